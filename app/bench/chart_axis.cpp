#include "app/bench/chart_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace ember {
namespace {

std::string plain(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string power_of_ten(int mantissa, int exponent, bool as_plain) {
    if (as_plain) return plain(mantissa * std::pow(10.0, exponent));
    return std::to_string(mantissa) + 'e' + std::to_string(exponent);
}

}  // namespace

ChartAxis::ChartAxis(AxisScale scale, const std::vector<double>& values, bool from_zero)
    : scale_(scale) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values) {
        if (!std::isfinite(value) || (scale == AxisScale::Logarithmic && !(value > 0))) continue;
        const double v = scale == AxisScale::Logarithmic ? std::log10(value) : value;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    if (!(low <= high)) low = 0, high = 1;
    if (from_zero) low = std::min(low, 0.0);
    double room = 0.05 * (high - low);
    if (!(room > 0)) room = scale == AxisScale::Logarithmic || low == 0 ? 0.5 : 0.1 * std::abs(low);
    low_ = from_zero && low == 0 ? 0 : low - room;
    high_ = high + room;
}

double ChartAxis::share(double value) const {
    const double v = scale_ == AxisScale::Logarithmic ? std::log10(value) : value;
    return (v - low_) / (high_ - low_);
}

bool ChartAxis::covers(double value) const {
    if (!std::isfinite(value) || (scale_ == AxisScale::Logarithmic && !(value > 0))) return false;
    const double at = share(value);
    return at >= 0 && at <= 1;
}

std::vector<AxisTick> ChartAxis::ticks() const {
    return scale_ == AxisScale::Logarithmic ? decades() : even_steps();
}

std::vector<AxisTick> ChartAxis::decades() const {
    const int first = static_cast<int>(std::floor(low_)), last = static_cast<int>(std::ceil(high_));
    const int every = std::max(1, (last - first + 8) / 9);
    const bool few = high_ - low_ < 2.2;
    const bool as_plain = first >= -2 && last <= 4;
    std::vector<AxisTick> ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
        for (int mantissa = 1; mantissa < 10; ++mantissa) {
            const double v = exponent + std::log10(mantissa);
            if (v < low_ || v > high_) continue;
            const bool named =
                mantissa == 1 ? exponent % every == 0 : few && (mantissa == 2 || mantissa == 5);
            if (every > 1 && mantissa > 1) continue;
            ticks.push_back({mantissa * std::pow(10.0, exponent),
                             named ? power_of_ten(mantissa, exponent, as_plain) : ""});
        }
    }
    return ticks;
}

std::vector<AxisTick> ChartAxis::even_steps() const {
    const double rough = (high_ - low_) / 6.0;
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (const double m : {5.0, 2.0, 1.0}) {
        if (m * decade >= rough) step = m * decade;
    }
    std::vector<AxisTick> ticks;
    for (double n = std::ceil(low_ / step); n * step <= high_; ++n)
        ticks.push_back({n * step, plain(n * step)});
    return ticks;
}

}  // namespace ember
