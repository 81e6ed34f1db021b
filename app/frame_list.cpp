#include "app/frame_list.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/exit_code.h"

namespace ember {
namespace {

constexpr long kMostFrames = 10'000'000;        // in a list
constexpr long kLastFrame = 1'000'000'000'000;  // beyond any film, and steps never overflow

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

struct FrameRange {
    long first = 0, last = 0, step = 1;
};

[[noreturn]] void refuse_frames(const std::string& text) {
    throw InputError(
        "--frames: error: expected frames such as 0..240, 0..240+5 or 1,40,80..90, got \"" + text +
        '"');
}

FrameRange parse_range(const std::string& part, const std::string& text) {
    const std::size_t dots = part.find(".."), plus = part.find('+');
    FrameRange range;
    bool good = parse_number(part.substr(0, dots), range.first);
    range.last = range.first;
    if (dots != std::string::npos) {
        good = good && parse_number(part.substr(dots + 2, plus - dots - 2), range.last);
        if (plus != std::string::npos)
            good = good && parse_number(part.substr(plus + 1), range.step);
    }
    if (!good || range.first < 0 || range.last < range.first || range.last > kLastFrame)
        refuse_frames(text);
    return range;
}

}  // namespace

std::vector<long> parse_frames(const std::string& text) {
    std::vector<FrameRange> ranges;
    for (const std::string& part : split(text, ',')) {
        if (part.starts_with('+')) {  // of the range before
            if (ranges.empty() || !parse_number(part.substr(1), ranges.back().step)) {
                refuse_frames(text);
            }
        } else {
            ranges.push_back(parse_range(part, text));
        }
        const FrameRange& range = ranges.back();
        if (range.step <= 0 || range.step > kLastFrame) refuse_frames(text);
    }
    long count = 0;
    for (const FrameRange& range : ranges) {
        count += (range.last - range.first) / range.step + 1;
        if (count > kMostFrames) refuse_frames(text);
    }
    std::vector<long> frames;
    for (const FrameRange& range : ranges) {
        for (long frame = range.first; frame <= range.last; frame += range.step)
            frames.push_back(frame);
    }
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

std::string rate_text(const std::string& text) {
    double above = 0, below = 1001;
    for (const double whole : {24, 30, 48, 60, 120}) {  // NTSC's slower ones, to three digits
        double rate = 0;
        if (parse_number(text, rate) && std::abs(rate - whole / 1.001) < 0.006)
            above = 1000 * whole;
    }
    const std::size_t slash = text.find('/');
    const bool fraction = slash != std::string::npos &&
                          parse_number(text.substr(0, slash), above) &&
                          parse_number(text.substr(slash + 1), below) && below > 0;
    if (above <= 0 || (!fraction && slash != std::string::npos)) return text;
    std::array<char, 32> digits{};  // all of them, so that it is the same number again
    const auto end = std::to_chars(digits.begin(), digits.end(), above / below).ptr;
    return {digits.begin(), end};
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

PictureSize parse_size(const std::string& text, const std::string& flag,
                       const std::string& expected) {
    const std::vector<std::string> parts = split(text, 'x');
    PictureSize size;
    const bool good = parts.size() == 2 && parse_number(parts[0], size.width) &&
                      parse_number(parts[1], size.height) && size.width >= 1 && size.height >= 1 &&
                      size.width <= 16384 && size.height <= 16384;
    if (!good) {
        throw InputError(flag + ": error: expected " + expected + " up to 16384x16384, got \"" +
                         text + '"');
    }
    return size;
}

}  // namespace ember
