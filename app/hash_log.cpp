#include "app/hash_log.h"

#include <charconv>
#include <fstream>

#include "app/exit_code.h"
#include "app/stats_json.h"

namespace ember {
namespace {

constexpr std::size_t kDigits = 16;

// Hashes of fast arithmetic are those of one processor, so they go by another name.
std::string title_for(Arithmetic arithmetic) {
    return arithmetic == Arithmetic::Fast ? "tick fast_state_hash" : "tick state_hash";
}

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& reason) {
    throw InputError(file + ':' + std::to_string(line) + ": error: " + reason);
}

template <class Number>
bool read_number(std::string_view text, int base, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

HashLog::HashLog(const World& world) : title_(title_for(world.params().numerics.arithmetic)) {}

HashLog::HashLog(const std::filesystem::path& file) : name_(file.string()) {
    std::ifstream in(file);
    if (!in) throw InputError(name_ + ": error: cannot be read");
    std::getline(in, title_);
    if (title_ != title_for(Arithmetic::Exact) && title_ != title_for(Arithmetic::Fast))
        refuse(name_, 1, "not a file of state hashes, as simulate --hashes writes them");
    std::string line;
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        const std::size_t space = line.find(' ');
        std::uint64_t tick = 0, hash = 0;
        if (space == std::string::npos || line.size() != space + 1 + kDigits ||
            !read_number(std::string_view(line).substr(0, space), 10, tick) ||
            !read_number(std::string_view(line).substr(space + 1), 16, hash)) {
            refuse(name_, number, "expected a tick and a hash of 16 hexadecimal digits");
        }
        if (hashes_.empty()) first_ = tick;
        if (tick - first_ != hashes_.size())
            refuse(name_, number, "expected tick " + std::to_string(first_ + hashes_.size()));
        hashes_.push_back(hash);
    }
    if (hashes_.empty()) refuse(name_, 1, "no hash follows");
}

void HashLog::record(const World& world) {
    if (hashes_.empty()) first_ = world.state().tick;
    hashes_.push_back(world.hash());
}

std::string HashLog::text() const {
    std::string text = title_ + '\n';
    for (std::size_t i = 0; i < hashes_.size(); ++i)
        text += std::to_string(first_ + i) + ' ' + hash_text(hashes_[i]) + '\n';
    return text;
}

std::string HashLog::difference(const World& world) const {
    if (title_ != title_for(world.params().numerics.arithmetic))
        return name_ + ":1: of another arithmetic, \"" + title_ + '"';
    const std::uint64_t tick = world.state().tick;
    if (tick < first_ || tick > last_tick())
        return name_ + ": tick " + std::to_string(tick) + " is not in it";
    const std::size_t i = tick - first_;
    const std::uint64_t hash = world.hash();
    if (hash == hashes_[i]) return {};
    return name_ + ':' + std::to_string(i + 2) + ": tick " + std::to_string(tick) +
           " is the first that differs: state hash " + hash_text(hash) + ", expected " +
           hash_text(hashes_[i]);
}

}  // namespace ember
