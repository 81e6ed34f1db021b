#include "ui/lighter_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ember {
namespace {

constexpr double kBelow = 0.020;    // [m]
constexpr double kGrain = 0.0001;   // [m] nobody aims finer
constexpr double kInwards = 0.005;  // [m]
constexpr double kRim = 0.010;      // [m] height of what counts as the lowest rim

}  // namespace

std::optional<Vector3> lighter_below(const SheetView& sheet, LighterSpot spot) {
    std::vector<Vector3> rim;
    double lowest = std::numeric_limits<double>::infinity();
    const auto burns = [&](std::size_t n) {
        return sheet.phase[n] != Phase::BurntOut && sheet.initial_mass[n] > 0;
    };
    for (std::size_t n = 0; n < sheet.y.size(); ++n) {
        if (burns(n)) lowest = std::min(lowest, sheet.y[n]);
    }
    for (std::size_t n = 0; n < sheet.y.size(); ++n) {
        if (burns(n) && sheet.y[n] <= lowest + kRim) {
            rim.push_back({sheet.x[n], sheet.y[n], sheet.z[n]});
        }
    }
    if (rim.empty()) return std::nullopt;
    const auto [left, right] = std::ranges::minmax(rim, {}, [](const Vector3& p) { return p.x(); });
    const double middle = 0.5 * (left.x() + right.x());
    const double inset = std::min(kInwards, 0.5 * (right.x() - left.x()));
    double x = middle;
    if (spot == LighterSpot::LeftCorner) x = left.x() + inset;
    if (spot == LighterSpot::RightCorner) x = right.x() - inset;
    // of the nodes about there, the one nearest to the viewer
    const auto off = [&](const Vector3& p) { return std::abs(p.x() - x) - 0.1 * p.z(); };
    const Vector3 nearest = *std::ranges::min_element(rim, {}, off);
    return Vector3(x, lowest - kBelow, nearest.z());
}

void move_lighter(LighterParams& lighter, const Vector3& place, bool lit, double now) {
    const auto whole = [](double length) {
        return std::round(length / kGrain) * kGrain + 0.0;  // never -0
    };
    lighter.x = whole(place.x());
    lighter.y = whole(place.y());
    lighter.z = whole(place.z());
    lighter.path.clear();  // put there by hand, it stays there
    if (lit) return;
    lighter.on = true;
    lighter.start = now;
}

void extend_path(LighterParams& lighter, double time, double tick) {
    auto& path = lighter.path;
    while (!path.empty() && path.back()[0] >= time)
        path.pop_back();
    if (!path.empty() && path.back()[0] < time - tick) {
        path.push_back(path.back());
        path.back()[0] = time - tick;
    }
    path.push_back({time, lighter.x, lighter.y, lighter.z});
}

}  // namespace ember
