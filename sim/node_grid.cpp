#include "sim/node_grid.h"

#include <algorithm>
#include <cmath>

#include "sim/random.h"

namespace ember {

void NodeGrid::fill(std::span<const SheetInSpace> sheets, double size, double dt) {
    per_metre_ = 1.0 / size;
    half_path_ = 0;
    const std::size_t count = nodes.size();
    std::size_t buckets = 16;
    while (buckets < 2 * count)
        buckets *= 2;
    mask_ = buckets - 1;
    cell_.resize(count);
    bucketed_.resize(count);
    bucket_begin_.assign(buckets + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const SheetState& sheet = *sheets[static_cast<std::size_t>(nodes[i].sheet)].sheet;
        const auto n = static_cast<std::size_t>(nodes[i].node);
        const Vector3 half = 0.5 * dt * sheet.velocity.at(n);
        const Vector3 middle = sheet.position.at(n) + half;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            cell_[i][static_cast<std::size_t>(axis)] = place(middle[axis]);
        half_path_ = std::max(half_path_, half.lpNorm<Eigen::Infinity>());
        ++bucket_begin_[bucket(cell_[i]) + 1];
    }
    for (std::size_t b = 0; b < buckets; ++b)
        bucket_begin_[b + 1] += bucket_begin_[b];
    // from the last node on, so that the end of each bucket becomes its begin, in order of nodes
    for (std::size_t i = count; i-- > 0;) {
        Index& end = bucket_begin_[bucket(cell_[i]) + 1];
        bucketed_[static_cast<std::size_t>(--end)] = static_cast<Index>(i);
    }
    std::copy(bucket_begin_.begin() + 1, bucket_begin_.end(), bucket_begin_.begin());
    bucket_begin_[buckets] = static_cast<Index>(count);
}

// Far away all is one cell; what is not a number is there too.
Index NodeGrid::place(double x) const {
    constexpr double kFar = 1e9;
    const double cell = std::floor(x * per_metre_);
    return static_cast<Index>(cell < kFar ? (cell > -kFar ? cell : -kFar) : kFar);
}

std::size_t NodeGrid::bucket(const std::array<Index, 3>& cell) const {
    const auto bits = [](Index i) { return std::uint64_t{static_cast<std::uint32_t>(i)}; };
    return mix(bits(cell[0]) ^ (bits(cell[1]) << 21) ^ (bits(cell[2]) << 42)) & mask_;
}

}  // namespace ember
