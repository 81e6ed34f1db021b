#include "sim/swept_box.h"

#include <algorithm>

#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr std::ptrdiff_t kLanesWide = 8;

const std::vector<double>& axis_of(const Vector3Array& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// Bounds of x and x + v dt, in eight lanes side by side, which a single minimum would not be.
EMBER_VECTORISED void sweep(std::ptrdiff_t count, const double* __restrict x,
                            const double* __restrict v, double dt, double* __restrict low,
                            double* __restrict high) {
    for (std::ptrdiff_t i = 0; i < count; i += kLanesWide) {
        const std::ptrdiff_t first = std::min(i, std::max(count - kLanesWide, std::ptrdiff_t{0}));
        const std::ptrdiff_t lanes = std::min(kLanesWide, count);
        for (std::ptrdiff_t l = 0; l < lanes; ++l) {
            const double a = x[first + l], b = a + v[first + l] * dt;
            const double least = a < b ? a : b, most = a < b ? b : a;
            low[l] = least < low[l] ? least : low[l];
            high[l] = most > high[l] ? most : high[l];
        }
    }
}

}  // namespace

bool overlap(const SweptBox& a, const SweptBox& b, double reach) {
    bool apart = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
        apart |= !(a.low[axis] <= b.high[axis] + reach) || !(b.low[axis] <= a.high[axis] + reach);
    return !apart;
}

SweptBox swept_by_node(const SheetState& sheet, std::size_t n, double dt) {
    const Vector3 a = sheet.position.at(n), b = a + dt * sheet.velocity.at(n);
    SweptBox box = kEmptyBox;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        box.include(axis, std::min(a[i], b[i]), std::max(a[i], b[i]));
    }
    return box;
}

SweptBox swept_by_quad(const SheetState& sheet, std::size_t quad, double dt) {
    SweptBox box = kEmptyBox;
    for (const Index node : sheet.quads[quad])
        box.include(swept_by_node(sheet, static_cast<std::size_t>(node), dt));
    return box;
}

SweptBox swept_by_rows(const Lattice& lattice, const SheetState& sheet, double dt,
                       std::size_t first, std::size_t last, std::vector<SweptBox>& rows) {
    rows.assign(static_cast<std::size_t>(lattice.row_count), kEmptyBox);
    for (std::size_t axis = first; axis <= last; ++axis) {
        const double* x = axis_of(sheet.position, axis).data();
        const double* v = axis_of(sheet.velocity, axis).data();
        for (Index r = 0; r < lattice.row_count; ++r) {
            std::array<double, kLanesWide> low, high;
            low.fill(kFarAway), high.fill(-kFarAway);
            const Index at = lattice.site(r, 0);
            sweep(lattice.column_count, x + at, v + at, dt, low.data(), high.data());
            rows[static_cast<std::size_t>(r)].include(axis,
                                                      *std::min_element(low.begin(), low.end()),
                                                      *std::max_element(high.begin(), high.end()));
        }
        for (auto n = static_cast<std::size_t>(lattice.site_count()); n < sheet.mass.size(); ++n) {
            const double end = x[n] + v[n] * dt;
            rows[static_cast<std::size_t>(lattice.row_of(sheet.site[n]))].include(
                axis, std::min(x[n], end), std::max(x[n], end));
        }
    }
    SweptBox whole = kEmptyBox;
    for (const SweptBox& row : rows)
        whole.include(row);
    return whole;
}

}  // namespace ember
