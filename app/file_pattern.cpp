#include "app/file_pattern.h"

#include <filesystem>
#include <regex>

#include "app/exit_code.h"

namespace ember {

FilePattern::FilePattern(const std::string& text) {
    static const std::regex place("#+|%(0([1-9]))?d");
    const auto begin = std::sregex_iterator(text.begin(), text.end(), place);
    const auto places = std::distance(begin, std::sregex_iterator());
    if (places > 1) throw InputError(text + ": more than one place for the number");
    if (places == 1) {
        const std::smatch& match = *begin;
        before_ = match.prefix();
        after_ = match.suffix();
        const bool hashes = match.str().front() == '#';
        width_ = hashes ? match.str().size() : match[2].matched ? std::stoul(match[2]) : 1;
    } else {
        const std::filesystem::path path(text);
        before_ = (path.parent_path() / path.stem()).string() + '_';
        after_ = path.extension().string();
    }
    if ((before_ + after_).find('%') != std::string::npos) {
        throw InputError(text + ": expected ####, %d or %0Nd as the place of the number");
    }
}

std::string FilePattern::name(long number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < width_) digits.insert(0, width_ - digits.size(), '0');
    return before_ + digits + after_;
}

}  // namespace ember
