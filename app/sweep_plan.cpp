#include "app/sweep_plan.h"

#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include "app/exit_code.h"
#include "app/preset_io/parameter_value.h"

namespace ember {
namespace {

constexpr std::size_t kMostCases = 10'000;

template <class T>
bool parse_number(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

[[noreturn]] void refuse(const std::string& text) {
    throw InputError(
        "--vary: error: expected KEY=60,80,120, KEY=1..5:9 or KEY=1e-4..1e-2:log:5, "
        "got \"" +
        text + '"');
}

// "A..B:N" or "A..B:log:N"
std::vector<std::string> range_values(const std::string& range, const std::string& text) {
    const std::size_t dots = range.find(".."), colon = range.find(':', dots);
    const bool logarithmic = range.compare(std::min(colon, range.size()), 5, ":log:") == 0;
    if (colon == std::string::npos) refuse(text);
    double first = 0, last = 0;
    int count = 0;
    const bool good =
        parse_number(std::string_view(range).substr(0, dots), first) &&
        parse_number(std::string_view(range).substr(dots + 2, colon - dots - 2), last) &&
        parse_number(std::string_view(range).substr(colon + (logarithmic ? 5 : 1)), count);
    if (!good || count < 2 || count > 1000 || (logarithmic && !(first > 0 && last > 0)))
        refuse(text);
    std::vector<std::string> values;
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        double value =
            logarithmic ? first * std::pow(last / first, share) : first + share * (last - first);
        if (i == count - 1) value = last;
        std::ostringstream rounded;  // nobody reads more, and a table stays narrow
        rounded.precision(6);
        rounded << value;
        values.push_back(rounded.str());
    }
    return values;
}

}  // namespace

SweepAxis parse_axis(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) refuse(text);
    SweepAxis axis{text.substr(0, equals), {}};
    const std::string list = text.substr(equals + 1);
    if (list.find("..") != std::string::npos) {
        axis.values = range_values(list, text);
        return axis;
    }
    std::istringstream in(list);
    for (std::string value; std::getline(in, value, ',');) {
        if (value.empty()) refuse(text);
        axis.values.push_back(value);
    }
    return axis;
}

std::vector<SweepCase> sweep_cases(const std::vector<SweepAxis>& axes) {
    std::vector<SweepCase> cases{{}};
    std::set<std::string> keys;
    for (const SweepAxis& axis : axes) {
        if (!keys.insert(axis.key).second)
            throw InputError("--vary: error: " + axis.key + " is varied twice");
        std::vector<SweepCase> longer;
        for (const SweepCase& shorter : cases) {
            for (const std::string& value : axis.values) {
                longer.push_back(shorter);
                longer.back().emplace_back(axis.key, value);
            }
        }
        if (longer.size() > kMostCases) throw InputError("--vary: error: more than 10000 cases");
        cases = std::move(longer);
    }
    return cases;
}

SweepShare parse_share(const std::string& text) {
    const std::size_t slash = text.find('/');
    SweepShare share;
    const bool good = slash != std::string::npos &&
                      parse_number(std::string_view(text).substr(0, slash), share.number) &&
                      parse_number(std::string_view(text).substr(slash + 1), share.of);
    if (!good || share.number < 1 || share.of < share.number)
        throw InputError("--array: error: expected K/N such as 2/8, got \"" + text + '"');
    return share;
}

}  // namespace ember
