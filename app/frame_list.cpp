#include "app/frame_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/exit_code.h"

namespace ember {
namespace {

constexpr long kMostFrames = 10'000'000;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::string part;
    std::istringstream in(text);
    while (std::getline(in, part, separator))
        parts.push_back(part);
    if (text.empty() || text.back() == separator) parts.emplace_back();
    return parts;
}

template <class T>
bool parse_number(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

[[noreturn]] void refuse_frames(const std::string& text) {
    throw InputError(
        "--frames: error: expected frames such as 0..240, 0..240+5 or 1,40,80..90, got \"" + text +
        '"');
}

}  // namespace

std::vector<long> parse_frames(const std::string& text) {
    std::vector<long> frames;
    for (const std::string& part : split(text, ',')) {
        const std::size_t dots = part.find(".."), plus = part.find('+');
        long first = 0, last = 0, step = 1;
        bool good = parse_number(part.substr(0, dots), first);
        last = first;
        if (dots != std::string::npos) {
            good = good && parse_number(part.substr(dots + 2, plus - dots - 2), last);
            if (plus != std::string::npos) {
                good = good && parse_number(part.substr(plus + 1), step);
            }
        }
        const bool ordered = first >= 0 && last >= first && step > 0;
        if (!good || !ordered || (last - first) / std::max(step, 1l) > kMostFrames) {
            refuse_frames(text);
        }
        for (long frame = first; frame <= last; frame += step)
            frames.push_back(frame);
    }
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

std::vector<double> parse_times(const std::string& text) {
    std::vector<double> times;
    for (const std::string& part : split(text, ',')) {
        double time = 0;
        if (!parse_number(part, time) || !std::isfinite(time) || time < 0) {
            throw InputError("--at: error: expected times in seconds such as 0.5,1,2, got \"" +
                             text + '"');
        }
        times.push_back(time);
    }
    std::sort(times.begin(), times.end());
    return times;
}

PictureSize parse_size(const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    PictureSize size;
    const bool good = parts.size() == 2 && parse_number(parts[0], size.width) &&
                      parse_number(parts[1], size.height) && size.width >= 1 && size.height >= 1 &&
                      size.width <= 16384 && size.height <= 16384;
    if (!good) {
        throw InputError("--size: error: expected WIDTHxHEIGHT up to 16384x16384, got \"" + text +
                         '"');
    }
    return size;
}

}  // namespace ember
