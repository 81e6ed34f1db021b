#include "app/file_pattern.h"

#include <filesystem>
#include <regex>

#include "app/exit_code.h"

namespace ember {

FilePattern::FilePattern(const std::string& text, bool several) {
    static const std::regex place("#+|%(0([1-9]))?d|\\{frame(:([1-9]))?\\}");
    const std::filesystem::path path(text);
    const std::string name = path.filename().string();
    const std::string folder = text.substr(0, text.size() - name.size());
    const auto begin = std::sregex_iterator(name.begin(), name.end(), place);
    const auto places = std::distance(begin, std::sregex_iterator());
    if (places > 1) throw InputError(text + ": error: more than one place for the number");
    if (places == 1) {
        const std::smatch& match = *begin;
        before_ = folder + match.prefix().str();
        after_ = match.suffix();
        const bool hashes = match.str().front() == '#';
        const auto& digits = match[2].matched ? match[2] : match[4];
        width_ = hashes ? match.str().size() : digits.matched ? std::stoul(digits) : 1;
    } else if (!several) {
        before_ = text;
        numbered_ = false;
    } else {
        before_ = folder + path.stem().string() + '_';
        after_ = path.extension().string();
    }
    const bool strange =
        (before_ + after_).find_first_of("%{}", folder.size()) != std::string::npos;
    if (name.empty() || strange) {
        throw InputError(
            text + ": error: expected a name with ####, %d, %0Nd or {frame:N} for the number");
    }
}

std::string FilePattern::name(long number) const {
    if (!numbered_) return before_;
    std::string digits = std::to_string(number);
    if (digits.size() < width_) digits.insert(0, width_ - digits.size(), '0');
    return before_ + digits + after_;
}

}  // namespace ember
