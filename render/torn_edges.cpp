#include "render/torn_edges.h"

#include <algorithm>

namespace ember {
namespace {

using Shifts = std::vector<std::array<double, 2>>;

// The polygon between cells with and without paper, in cells of the lattice.
class Outline {
  public:
    explicit Outline(const SheetView& sheet)
        : columns_(sheet.column_count), rows_(sheet.row_count), closed_(sheet.closed) {
        paper_.resize(static_cast<std::size_t>(rows_ * columns_));
        moved_.resize(paper_.size());
        beside_.resize(paper_.size());
        for (const Quad& quad : sheet.quads)
            paper_[static_cast<std::size_t>(sheet.site[static_cast<std::size_t>(quad[0])])] = 1;
        for (Index row = 0; row < rows_; ++row) {
            for (Index column = 0; column < columns_; ++column) {
                if (cell(row, column) != cell(row - 1, column)) join(row, column, row, column + 1);
                if (cell(row, column) != cell(row, column - 1)) join(row, column, row + 1, column);
            }
        }
    }

    // Leaves holes of a few cells as they are: the filter would close them.
    void keep_small_holes() {
        std::vector<std::size_t> small;
        for (std::size_t s = 0; s < beside_.size(); ++s) {
            std::size_t before = s, at = s;
            int steps = 0;
            do {
                if (beside_[at].size() != 2) break;
                const std::size_t next = beside_[at][beside_[at][0].site == before ? 1 : 0].site;
                before = at;
                at = next;
            } while (++steps < kSmallHole && at != s);
            if (at == s && steps > 0) small.push_back(s);
        }
        for (const std::size_t s : small)
            beside_[s].clear();
    }

    // One step of the filter: every site by `share` towards the middle of both neighbours.
    void filter(double share) {
        const Shifts before = moved_;
        for (std::size_t s = 0; s < beside_.size(); ++s) {
            if (beside_[s].size() != 2) continue;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const auto ahead = [&](const Step& step) {
                    return step.away[axis] + before[step.site][axis] - before[s][axis];
                };
                const double mean = 0.5 * (ahead(beside_[s][0]) + ahead(beside_[s][1]));
                moved_[s][axis] = std::clamp(before[s][axis] + share * mean, -0.45, 0.45);
            }
        }
    }

    [[nodiscard]] const std::array<double, 2>& of(Index site) const {
        return moved_[static_cast<std::size_t>(site)];
    }

  private:
    static constexpr int kSmallHole = 12;  // [edges]
    struct Step {
        std::size_t site;
        std::array<double, 2> away;  // [cells] main, cross
    };

    // 1 or 0; -1 beyond the lattice, where the border of the sheet is no outline of ours
    [[nodiscard]] int cell(Index row, Index column) const {
        if (closed_) row = (row + rows_) % rows_;
        const Index last = closed_ ? rows_ : rows_ - 1;
        if (row < 0 || row >= last || column < 0 || column >= columns_ - 1) return -1;
        return paper_[static_cast<std::size_t>(row * columns_ + column)];
    }
    void join(Index row, Index column, Index to_row, Index to_column) {
        const bool beyond = column >= columns_ || to_column >= columns_ ||
                            (!closed_ && (row >= rows_ || to_row >= rows_));
        const bool border = column == 0 || column == columns_ - 1 || (!closed_ && row == 0) ||
                            (!closed_ && row == rows_ - 1);
        const bool to_border = to_column == 0 || to_column == columns_ - 1 ||
                               (!closed_ && (to_row == 0 || to_row == rows_ - 1));
        if (beyond || (border && to_border)) return;
        const auto a = static_cast<std::size_t>(row * columns_ + column);
        const auto b = static_cast<std::size_t>(to_row % rows_ * columns_ + to_column);
        const std::array<double, 2> away{static_cast<double>(to_column - column),
                                         static_cast<double>(to_row - row)};
        if (!border) beside_[a].push_back({b, away});
        if (!to_border) beside_[b].push_back({a, {-away[0], -away[1]}});
    }

    Index columns_, rows_;
    bool closed_;
    std::vector<int> paper_;  // by the first site of a cell
    Shifts moved_;            // [cells] main, cross
    std::vector<std::vector<Step>> beside_;
};

// Noise in -1 .. 1 of a site.
double noise(Index site, std::uint64_t lane) {
    std::uint64_t h = (2 * static_cast<std::uint64_t>(site) + lane + 1) * 0x9E3779B97F4A7C15ull;
    h ^= h >> 32;
    h *= 0xD6E8FEB86659FD93ull;
    h ^= h >> 32;
    return static_cast<double>(h >> 11) * 0x1p-52 - 1.0;
}

}  // namespace

std::vector<std::array<double, 2>> outline_shifts(const SheetView& sheet) {
    const Index across = sheet.closed ? sheet.row_count : sheet.row_count - 1;
    const Index cells = across * (sheet.column_count - 1);
    if (static_cast<Index>(sheet.quads.size()) == cells) return {};
    Outline outline(sheet);
    outline.keep_small_holes();
    constexpr int kRounds = 80;  // smooths steps of up to eight cells
    for (int round = 0; round < kRounds; ++round) {
        outline.filter(0.50);
        outline.filter(-0.51);
    }
    const double hx = sheet.height / (sheet.column_count - 1), hz = sheet.width / across;
    Shifts shifts;
    shifts.reserve(sheet.site.size());
    for (const Index site : sheet.site)
        shifts.push_back({hx * outline.of(site)[0], hz * outline.of(site)[1]});
    return shifts;
}

std::vector<std::array<double, 2>> edge_shifts(const SheetView& sheet, double ragged) {
    Shifts shifts = torn_edge_shifts(sheet);
    const Shifts outline = outline_shifts(sheet);
    if (shifts.empty() && outline.empty() && ragged == 0) return {};
    shifts.resize(sheet.site.size());
    const double cell_x = sheet.height / (sheet.column_count - 1);
    const double cell_z = sheet.width / (sheet.closed ? sheet.row_count : sheet.row_count - 1);
    const auto within = [](double shift, double cell) {
        return std::clamp(shift, -0.5 * cell, 0.5 * cell);
    };
    for (std::size_t n = 0; n < shifts.size(); ++n) {
        const Index site = sheet.site[n];
        const Index row = site / sheet.column_count, column = site % sheet.column_count;
        const bool curve = !outline.empty() && (outline[n][0] != 0 || outline[n][1] != 0);
        const bool inside = column > 0 && column < sheet.column_count - 1 &&
                            (sheet.closed || (row > 0 && row < sheet.row_count - 1));
        std::array<double, 2> more{};
        if (curve) {
            more = outline[n];
        } else if (inside) {
            more = {ragged * cell_x * noise(site, 0), ragged * cell_z * noise(site, 1)};
        }
        shifts[n] = {within(shifts[n][0] + more[0], cell_x),
                     within(shifts[n][1] + more[1], cell_z)};
    }
    return shifts;
}

std::vector<std::array<double, 2>> torn_edge_shifts(const SheetView& sheet) {
    std::vector<std::array<double, 2>> shifts;
    if (sheet.crack_x.empty()) return shifts;
    const double half_x = 0.5 * sheet.height / (sheet.column_count - 1);
    const double half_z =
        0.5 * sheet.width / (sheet.closed ? sheet.row_count : sheet.row_count - 1);
    const Index last_row = sheet.row_count - 1, last_column = sheet.column_count - 1;
    shifts.reserve(sheet.site.size());
    for (const Index site : sheet.site) {
        const auto s = static_cast<std::size_t>(site);
        const Index row = site / sheet.column_count, column = site % sheet.column_count;
        // the outline of the sheet stays what it is
        const bool end = column == 0 || column == last_column;
        const bool side = !sheet.closed && (row == 0 || row == last_row);
        shifts.push_back({end ? 0.0 : std::clamp(sheet.crack_x[s], -half_x, half_x),
                          side ? 0.0 : std::clamp(sheet.crack_z[s], -half_z, half_z)});
    }
    return shifts;
}

std::vector<Vector3> torn_positions(const SheetView& sheet,
                                    std::span<const std::array<double, 2>> shifts) {
    if (shifts.empty()) return {};
    const double hx = sheet.height / (sheet.column_count - 1);
    const double hz = sheet.width / (sheet.closed ? sheet.row_count : sheet.row_count - 1);
    const auto at = [&](Index node) {
        const auto n = static_cast<std::size_t>(node);
        return Vector3(sheet.x[n], sheet.y[n], sheet.z[n]);
    };
    std::vector<Vector3> moved(shifts.size(), Vector3(Vector3::Zero()));
    std::vector<double> quads(shifts.size(), 0.0);
    for (const Quad& q : sheet.quads) {
        for (int k = 0; k < 4; ++k) {
            const auto corner = [&](int i) { return q[static_cast<std::size_t>(i)]; };
            const auto n = static_cast<std::size_t>(corner(k));
            const auto& s = shifts[n];
            quads[n] += 1.0;
            if (s[0] == 0 && s[1] == 0) continue;
            // edges of the quad at this corner, along the main and the cross direction
            const Vector3 along = (at(corner(k ^ 1)) - at(corner(k))) / (k % 3 == 0 ? hx : -hx);
            const Vector3 across = (at(corner(3 - k)) - at(corner(k))) / (k < 2 ? hz : -hz);
            moved[n] += s[0] * along + s[1] * across;
        }
    }
    for (std::size_t n = 0; n < moved.size(); ++n)
        moved[n] = at(static_cast<Index>(n)) + (quads[n] > 0 ? moved[n] / quads[n] : moved[n]);
    return moved;
}

}  // namespace ember
