#include "ui/read_outs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/param_table.h"

namespace ember {
namespace {

constexpr std::size_t kFewest = 8;
constexpr double kSlowSpread = 0.35e-3, kFastSpread = 0.56e-3;  // [kg/(m s)]

void add_speeds(const SheetView& sheet, double from, std::vector<double>& speeds) {
    const Index rows = sheet.row_count, columns = sheet.column_count;
    const double dz = sheet.width / (sheet.closed ? rows : rows - 1);
    const double dx = sheet.height / (columns - 1);
    const auto at = [&](Index r, Index c) {
        return sheet.ignition_time[static_cast<std::size_t>(r * columns + c)];
    };
    for (Index r = 1; r + 1 < rows; ++r) {
        for (Index c = 1; c + 1 < columns; ++c) {
            if (!std::isfinite(at(r, c)) || at(r, c) < from) continue;
            const double along = (at(r, c + 1) - at(r, c - 1)) / (2 * dx);
            const double across = (at(r + 1, c) - at(r - 1, c)) / (2 * dz);
            const double slope = std::hypot(along, across);
            if (std::isfinite(slope) && slope > 0) speeds.push_back(1 / slope);
        }
    }
}

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
    char out[96];
    std::snprintf(out, sizeof out, format, numbers...);
    return out;
}

}  // namespace

std::optional<double> front_speed(const WorldView& world, double window) {
    std::vector<double> speeds;
    for (const SheetView& sheet : world.sheets) {
        if (sheet.row_count >= 3 && sheet.column_count >= 3)
            add_speeds(sheet, world.time - window, speeds);
    }
    if (speeds.size() < kFewest) return std::nullopt;
    const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
    std::nth_element(speeds.begin(), middle, speeds.end());
    return *middle;
}

SpeedRange real_front_speed(double grammage) {
    return {kSlowSpread / grammage, kFastSpread / grammage};
}

std::vector<ReadOut> read_outs(const Params& params, const WorldView& world,
                               std::int64_t substeps) {
    std::vector<ReadOut> lines;
    lines.push_back({"caliper", text("%.0f \u00b5m", 1e6 * caliper(params.paper))});
    const SheetView& sheet = world.sheets.front();
    const double sites = static_cast<double>(sheet.row_count) * sheet.column_count;
    const double weight = params.paper.grammage * sheet.width * sheet.height / sites;
    lines.push_back({"mass of a node", text("%.3g mg", 1e6 * weight)});
    const double tick = 1e3 / params.numerics.tick_rate;
    if (substeps > 0)
        lines.push_back(
            {"stable step", text("%.3g ms, %lld per tick", tick / static_cast<double>(substeps),
                                 static_cast<long long>(substeps))});
    const SpeedRange real = real_front_speed(params.paper.grammage);
    const auto front = front_speed(world);
    lines.push_back(
        {"front", front ? text("%.1f mm/s; real paper %.1f to %.1f", 1e3 * *front, 1e3 * real.slow,
                               1e3 * real.fast)
                        : text("real paper %.1f to %.1f mm/s", 1e3 * real.slow, 1e3 * real.fast)});
    const double length = std::hypot(sheet.width, sheet.height);
    const double speed = front ? *front : 0.5 * (real.slow + real.fast);
    lines.push_back(
        {"burns for", text("%.2g s a node, %.0f s the sheet", world.burning_time, length / speed)});
    return lines;
}

}  // namespace ember
