#include "sim/particle_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/exp_array.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

// Halves of the radius: the cells that a sphere touches then hold about twice its volume, with
// whole ones over three times.
constexpr double kCellsPerRadius = 2.0;
// Where particles are few or spread far, larger cells: emptying and summing up the cells must not
// cost more than the particles do.
constexpr double kFewestCells = 4096, kCellsPerParticle = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Eight minima and maxima side by side, as one could not be vectorised.
EMBER_VECTORISED void extend(const double* __restrict values, std::size_t count,
                             double* __restrict low, double* __restrict high) {
    double least[8], most[8];
    for (int l = 0; l < 8; ++l)
        least[l] = *low, most[l] = *high;
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        for (std::size_t l = 0; l < 8; ++l) {
            least[l] = values[i + l] < least[l] ? values[i + l] : least[l];
            most[l] = values[i + l] > most[l] ? values[i + l] : most[l];
        }
    }
    for (; i < count; ++i) {
        least[0] = values[i] < least[0] ? values[i] : least[0];
        most[0] = values[i] > most[0] ? values[i] : most[0];
    }
    for (int l = 0; l < 8; ++l) {
        *low = std::min(*low, least[l]);
        *high = std::max(*high, most[l]);
    }
}

void extend(const Vector3Array& points, Box& box) {
    extend(points.x.data(), points.size(), &box.low[0], &box.high[0]);
    extend(points.y.data(), points.size(), &box.low[1], &box.high[1]);
    extend(points.z.data(), points.size(), &box.low[2], &box.high[2]);
}

constexpr Box kNothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

// The box of the particles that are near the box of the sheets; false when there are none.
bool size_box(const std::vector<SheetState>& sheets, const FireState& fire, double radius,
              ParticleGrid& grid) {
    Box sheet = kNothing, particles = kNothing;
    for (const SheetState& s : sheets)
        extend(s.position, sheet);
    extend(fire.position, particles);
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(sheet.low[axis]), std::abs(sheet.high[axis])});
    }
    if (!(largest < kInfinity)) return false;  // the check after the tick will name the node
    grid.reach = radius * (1.0 + 1e-9) + 1e-12 * largest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        grid.box.low[axis] = std::max(particles.low[axis], sheet.low[axis] - grid.reach);
        grid.box.high[axis] = std::min(particles.high[axis], sheet.high[axis] + grid.reach);
        if (!(grid.box.low[axis] <= grid.box.high[axis])) return false;
    }
    return true;
}

void size_cells(double radius, std::size_t particles, ParticleGrid& grid) {
    const double most = std::max(kFewestCells, kCellsPerParticle * static_cast<double>(particles));
    grid.cell = radius / kCellsPerRadius;
    for (;; grid.cell *= 1.25) {
        double cells = 1;
        std::array<double, 3> along{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            along[axis] = std::floor((grid.box.high[axis] - grid.box.low[axis]) / grid.cell) + 1.0;
            cells *= along[axis];
        }
        if (!(cells <= most)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis)
            grid.count[axis] = static_cast<Index>(along[axis]);
        grid.per_cell = 1.0 / grid.cell;
        return;
    }
}

// As ParticleGrid::cell_along for all axes at once; `outside` where the box does not hold it.
EMBER_VECTORISED void find_cells(const ParticleGrid& grid, const double* __restrict x,
                                 const double* __restrict y, const double* __restrict z,
                                 std::size_t particles, Index outside, Index* __restrict cell) {
    const Box box = grid.box;
    const double per_cell = grid.per_cell;
    const std::array<Index, 3> count = grid.count;
    for (std::size_t i = 0; i < particles; ++i) {
        const bool in = (x[i] >= box.low[0]) & (x[i] <= box.high[0]) & (y[i] >= box.low[1]) &
                        (y[i] <= box.high[1]) & (z[i] >= box.low[2]) & (z[i] <= box.high[2]);
        const auto ix = static_cast<Index>(in ? (x[i] - box.low[0]) * per_cell : 0.0);
        const auto iy = static_cast<Index>(in ? (y[i] - box.low[1]) * per_cell : 0.0);
        const auto iz = static_cast<Index>(in ? (z[i] - box.low[2]) * per_cell : 0.0);
        const Index cx = ix < count[0] ? ix : count[0] - 1;
        const Index cy = iy < count[1] ? iy : count[1] - 1;
        const Index cz = iz < count[2] ? iz : count[2] - 1;
        const Index at = (cz * count[1] + cy) * count[0] + cx;
        cell[i] = in ? at : outside;
    }
}

// Counting sort. Counts stand two places late, so that after the sum begin[c + 1] is the next free
// place of cell c, and its end once all have been placed.
void place(std::size_t particles, std::size_t outside, bool all, ParticleGrid& grid) {
    grid.begin.resize(outside + 3);  // assign() would make room for no more than these
    std::fill(grid.begin.begin(), grid.begin.end(), 0);
    for (std::size_t i = 0; i < particles; ++i)
        ++grid.begin[static_cast<std::size_t>(grid.cell_of[i]) + 2];
    for (std::size_t c = 2; c < outside + 3; ++c)
        grid.begin[c] += grid.begin[c - 1];
    grid.sorted = grid.begin[outside + 1];
    grid.listed = all ? static_cast<Index>(particles) : grid.sorted;
    grid.order.resize(particles);
    for (std::size_t i = 0; i < particles; ++i) {
        const auto at =
            static_cast<std::size_t>(grid.begin[static_cast<std::size_t>(grid.cell_of[i]) + 1]++);
        grid.order[at] = static_cast<Index>(i);
    }
}

void gather(const std::vector<double>& from, const std::vector<Index>& order, std::size_t count,
            std::vector<double>& to) {
    to.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        to[i] = from[static_cast<std::size_t>(order[i])];
}

EMBER_VECTORISED void find_ages(double time, double heating_time, std::size_t count,
                                double* __restrict values) {
    for (std::size_t i = 0; i < count; ++i)
        values[i] = (values[i] - time) / heating_time;
}

EMBER_VECTORISED void find_heating(double heating, double ambient, double span, std::size_t count,
                                   const double* __restrict freshness,
                                   const double* __restrict strength, double* __restrict values) {
    for (std::size_t i = 0; i < count; ++i)
        values[i] = heating * strength[i] * freshness[i] * (values[i] - ambient) / span;
}

}  // namespace

void sort_particles(const Params& params, double heating, double time, bool all,
                    const std::vector<SheetState>& sheets, const FireState& fire,
                    ParticleGrid& grid) {
    const std::size_t particles = fire.size();
    grid.sorted = grid.listed = 0;
    if (!size_box(sheets, fire, params.fire.kernel_radius, grid)) return;
    size_cells(params.fire.kernel_radius, particles, grid);
    const Index outside = grid.count[0] * grid.count[1] * grid.count[2];
    grid.cell_of.resize(particles);
    find_cells(grid, fire.position.x.data(), fire.position.y.data(), fire.position.z.data(),
               particles, outside, grid.cell_of.data());
    place(particles, static_cast<std::size_t>(outside), all, grid);
    const auto count = static_cast<std::size_t>(grid.listed);
    gather(fire.position.x, grid.order, count, grid.x);
    gather(fire.position.y, grid.order, count, grid.y);
    gather(fire.position.z, grid.order, count, grid.z);
    gather(fire.velocity.x, grid.order, count, grid.vx);
    gather(fire.velocity.y, grid.order, count, grid.vy);
    gather(fire.velocity.z, grid.order, count, grid.vz);
    gather(fire.birth, grid.order, count, grid.freshness);
    gather(fire.temperature, grid.order, count, grid.heating);
    gather(fire.strength, grid.order, count, grid.strength);
    for (auto* axis : {&grid.x, &grid.y, &grid.z})
        axis->resize(count + kLanes);
    find_ages(time, params.fire.heating_time, count, grid.freshness.data());
    exp_array(grid.freshness.data(), static_cast<std::ptrdiff_t>(count));
    find_heating(heating, params.heat.ambient, params.fire.temperature - params.heat.ambient, count,
                 grid.freshness.data(), grid.strength.data(), grid.heating.data());
}

}  // namespace ember
