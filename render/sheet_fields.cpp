#include "render/sheet_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ember {
namespace {

constexpr double kWarmth = 8.0;       // [mm] in which warmth ahead of a front falls to 1/e
constexpr double kScorchLead = 3.0;   // [mm] paper that only warms stays so far from char
constexpr double kUsualSpeed = 20.0;  // [mm/s] of a front of which nothing is known yet
constexpr double kReach = 60.0;       // [mm] fields are flat beyond

// Speed of the front when it passed a site [mm/s]: 1 / |grad ignition time|, upwind.
double front_speed(const SheetView& sheet, const SiteGrid& grid, Index row, Index column) {
    const std::size_t n = grid.site(row, column);
    const auto before = [&](Index r, Index c) {
        if (grid.closed) r = (r + grid.rows) % grid.rows;
        if (r < 0 || r >= grid.rows || c < 0 || c >= grid.columns) return 0.0;
        const double other = sheet.ignition_time[grid.site(r, c)];
        return std::max(0.0, sheet.ignition_time[n] - other);  // 0 where it has not ignited
    };
    const double x = std::max(before(row, column - 1), before(row, column + 1)) / grid.along;
    const double z = std::max(before(row - 1, column), before(row + 1, column)) / grid.across;
    const double slowness = std::sqrt(x * x + z * z);
    return slowness > 0 ? std::clamp(1 / slowness, 2.0, 200.0) : kUsualSpeed;
}

// Distance ahead of a front at which unburnt paper is as warm as this [mm].
double distance_by_warmth(double temperature, const WorldView& world) {
    const double share = (temperature - world.ambient) / (world.ignition - world.ambient);
    if (share >= 1) return 0;
    return share <= 0 ? kReach : std::min(kReach, -kWarmth * std::log(share));
}

// The node that stands for each site: its own, or where the sheet has no paper that of paper close
// by, so that no front is seen along an outline.
std::vector<std::size_t> sources_of(const SheetView& sheet, const SiteGrid& grid) {
    const std::size_t sites = grid.site(grid.rows, 0);
    std::vector<std::size_t> source(sites, sites);
    for (std::size_t n = 0; n < sites; ++n) {
        if (sheet.initial_mass[n] > 0) source[n] = n;
    }
    for (int ring = 0; ring < 3; ++ring) {
        const std::vector<std::size_t> before = source;
        for (std::size_t n = 0; n < sites; ++n) {
            if (before[n] < sites) continue;
            const auto column = static_cast<Index>(n) % grid.columns;
            const auto wide = static_cast<std::size_t>(grid.columns);
            if (column > 0) source[n] = std::min(source[n], before[n - 1]);
            if (column + 1 < grid.columns) source[n] = std::min(source[n], before[n + 1]);
            if (n >= wide) source[n] = std::min(source[n], before[n - wide]);
            if (n + wide < sites) source[n] = std::min(source[n], before[n + wide]);
        }
    }
    for (std::size_t n = 0; n < sites; ++n)
        source[n] = source[n] < sites ? source[n] : n;
    return source;
}

struct Levels {
    std::vector<float> ignition, burnout;  // [mm], about the distance behind the front near to it
};

Levels front_levels(const SheetView& sheet, const WorldView& world, const SiteGrid& grid,
                    const std::vector<std::size_t>& source) {
    Levels levels;
    for (Index row = 0; row < grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column) {
            const std::size_t n = source[grid.site(row, column)];
            if (sheet.phase[n] == Phase::Unburnt) {
                const double ahead = distance_by_warmth(sheet.temperature[n], world) + 1e-3;
                levels.ignition.push_back(static_cast<float>(-ahead));
                levels.burnout.push_back(
                    static_cast<float>(-ahead - kUsualSpeed * world.burning_time));
                continue;
            }
            const double speed = front_speed(sheet, grid, row, column);
            const double since = std::max(0.0, world.time - sheet.ignition_time[n]);
            levels.ignition.push_back(static_cast<float>(speed * since));
            const double left = sheet.mass[n] / sheet.initial_mass[n];
            const double to_go = (left - world.residual_mass) / (1 - world.residual_mass);
            const double after = sheet.phase[n] == Phase::BurntOut
                                     ? world.time - sheet.burnout_time[n]
                                     : -std::max(to_go, 1e-4) * world.burning_time;
            levels.burnout.push_back(static_cast<float>(speed * after));
        }
    }
    return levels;
}

SiteFields straight_on(const SiteFields& edge, const SiteFields& inner) {
    return {2 * edge.charred - inner.charred, 2 * edge.burnt - inner.burnt,
            2 * edge.age - inner.age, 2 * edge.temperature - inner.temperature};
}

}  // namespace

SiteGrid site_grid(const SheetView& sheet) {
    const Index across = sheet.closed ? sheet.row_count : sheet.row_count - 1;
    return {sheet.row_count, sheet.column_count, sheet.closed, 1e3 * sheet.width / across,
            1e3 * sheet.height / (sheet.column_count - 1)};
}

std::vector<SiteFields> site_fields(const SheetView& sheet, const WorldView& world) {
    const SiteGrid grid = site_grid(sheet);
    const std::vector<std::size_t> source = sources_of(sheet, grid);
    const Levels levels = front_levels(sheet, world, grid, source);
    const std::vector<float> charred = front_distance(grid, levels.ignition);
    const std::vector<float> burnt = front_distance(grid, levels.burnout);
    std::vector<SiteFields> fields(charred.size());
    const auto reach = static_cast<float>(kReach);
    for (std::size_t site = 0; site < fields.size(); ++site) {
        const std::size_t n = source[site];
        SiteFields& f = fields[site];
        f.charred = std::clamp(charred[site], -reach, reach);
        f.burnt = std::clamp(burnt[site], -reach, reach);
        if (sheet.phase[n] == Phase::Unburnt) {
            const double warmth = distance_by_warmth(sheet.temperature[n], world) + kScorchLead;
            f.charred = std::max(f.charred, static_cast<float>(-warmth));
        }
        f.age = sheet.phase[n] == Phase::BurntOut
                    ? static_cast<float>(world.time - sheet.burnout_time[n])
                    : std::max(-2.0f, f.burnt / static_cast<float>(kUsualSpeed));
        f.temperature = static_cast<float>(sheet.temperature[n] - 273.15);
    }
    return fields;
}

FieldGrid make_field_grid(const SheetView& sheet, const WorldView& world) {
    const std::vector<SiteFields> fields = site_fields(sheet, world);
    const Index rows = sheet.row_count, columns = sheet.column_count;
    FieldGrid grid{columns + 2 * kFieldBorder, {}};
    grid.fields.resize(static_cast<std::size_t>(grid.columns * (rows + 2 * kFieldBorder)));
    const auto texel = [&](Index row, Index column) -> SiteFields& {
        return grid.fields[static_cast<std::size_t>((row + kFieldBorder) * grid.columns + column +
                                                    kFieldBorder)];
    };
    for (Index row = 0; row < rows; ++row) {
        for (Index column = 0; column < columns; ++column)
            texel(row, column) = fields[static_cast<std::size_t>(row * columns + column)];
        for (Index k = 0; k < kFieldBorder; ++k) {
            texel(row, -1 - k) = straight_on(texel(row, -k), texel(row, 1 - k));
            const Index end = columns + k;
            texel(row, end) = straight_on(texel(row, end - 1), texel(row, end - 2));
        }
    }
    for (Index column = -kFieldBorder; column < columns + kFieldBorder; ++column) {
        for (Index k = 0; k < kFieldBorder; ++k) {
            const Index end = rows + k;
            if (sheet.closed) {
                texel(-1 - k, column) = texel(rows - 1 - k, column);
                texel(end, column) = texel(k, column);
            } else {
                texel(-1 - k, column) = straight_on(texel(-k, column), texel(1 - k, column));
                texel(end, column) = straight_on(texel(end - 1, column), texel(end - 2, column));
            }
        }
    }
    return grid;
}

SiteFields smooth_fields(const FieldGrid& grid, Index row, Index column, float s, float t) {
    // into the neighbour where the place lies there
    const auto enter = [](Index& cell, float& x) {
        const float over = std::floor(x);
        cell += static_cast<Index>(over);
        x -= over;
    };
    enter(row, t);
    enter(column, s);
    const auto weights = [](float x) {
        const float y = 1 - x;
        return std::array<float, 4>{y * y * y / 6, (4 - 6 * x * x + 3 * x * x * x) / 6,
                                    (4 - 6 * y * y + 3 * y * y * y) / 6, x * x * x / 6};
    };
    const std::array<float, 4> across = weights(t), along = weights(s);
    SiteFields sum{0, 0, 0, 0};
    for (Index i = 0; i < 4; ++i) {
        for (Index j = 0; j < 4; ++j) {
            const float w =
                across[static_cast<std::size_t>(i)] * along[static_cast<std::size_t>(j)];
            const SiteFields& f = grid.at(row - 1 + i, column - 1 + j);
            sum.charred += w * f.charred, sum.burnt += w * f.burnt;
            sum.age += w * f.age, sum.temperature += w * f.temperature;
        }
    }
    return sum;
}

}  // namespace ember
