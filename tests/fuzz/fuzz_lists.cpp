// The little languages of options: lists of frames and times, sizes, rates, names of files, keys.
#include <algorithm>
#include <cmath>

#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/frame_list.h"
#include "app/keyframes.h"
#include "app/sweep_plan.h"
#include "promise.h"

namespace ember {
namespace {

template <class Reader>
void try_to(Reader&& reader) {
    try {
        reader();
    } catch (const InputError& e) {
        promise(std::string(e.what()).find("error") != std::string::npos);
    }
}

// Lists of millions of frames are right, and too slow to look at often.
bool is_short(const std::string& text) {
    std::size_t digits = 0, longest = 0;
    for (const char c : text) {
        const bool leading = digits == 0 && c == '0';
        digits = c >= '0' && c <= '9' && !leading ? digits + 1 : 0;
        longest = std::max(longest, digits);
    }
    return longest < 6 || longest > 8;
}

void read(const std::string& text) {
    if (is_short(text)) {
        try_to([&] {
            const std::vector<long> frames = parse_frames(text);
            promise(!frames.empty() && frames.front() >= 0 && std::ranges::is_sorted(frames));
        });
    }
    try_to([&] {
        const std::vector<double> times = parse_times(text);
        promise(std::ranges::all_of(times, [](double t) { return t >= 0 && std::isfinite(t); }));
    });
    try_to([&] {
        const PictureSize size = parse_size(text);
        promise(size.width > 0 && size.width <= 16384 && size.height > 0 && size.height <= 16384);
    });
    static_cast<void>(rate_text(text));
    try_to([&] { static_cast<void>(FilePattern(text).name(7)); });
    try_to([&] { Keyframes().add(text); });
    try_to([&] { static_cast<void>(parse_axis(text)); });
    try_to([&] { static_cast<void>(parse_share(text)); });
}

}  // namespace
}  // namespace ember

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    ember::read(text.substr(0, text.find('\0')));  // no word of a command line has more
    return 0;
}
