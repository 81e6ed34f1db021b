#include "render/sheet_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/sheet_fields.h"
#include "render/torn_edges.h"

namespace ember {
namespace {

using Eigen::Vector3f;
using Corners = std::array<std::size_t, 4>;

Corners corners_of(const Quad& quad) {
    Corners corners{};
    for (std::size_t k = 0; k < 4; ++k)
        corners[k] = static_cast<std::size_t>(quad[k]);
    return corners;
}

Vector3f place(const SheetView& sheet, std::size_t n) {
    return Eigen::Vector3d(sheet.x[n], sheet.y[n], sheet.z[n]).cast<float>();
}

std::vector<Vector3f> node_normals(const SheetView& sheet) {
    std::vector<Vector3f> normals(sheet.x.size(), Vector3f::Zero());
    for (const Quad& quad : sheet.quads) {
        const Corners c = corners_of(quad);
        const Vector3f area = (place(sheet, c[2]) - place(sheet, c[0]))
                                  .cross(place(sheet, c[3]) - place(sheet, c[1]));
        for (const std::size_t n : c)
            normals[n] += area;
    }
    for (Vector3f& n : normals) {
        const float length = n.norm();
        n = length > 0 ? Vector3f(n / length) : Vector3f(Vector3f::UnitZ());
    }
    return normals;
}

// A cubic from a to b that starts and ends at right angles to the normals there, and the bilinear
// place that it replaces (Vlachos et al., Curved PN triangles, 2001, section 3).
struct Side {
    Vector3f a, b, near_a, near_b;
    Side(const Vector3f& from, const Vector3f& to, const Vector3f& n, const Vector3f& m)
        : a(from), b(to) {
        near_a = (2 * a + b - (b - a).dot(n) * n) / 3;
        near_b = (2 * b + a - (a - b).dot(m) * m) / 3;
    }
    [[nodiscard]] Vector3f at(float x) const {
        const float y = 1 - x;
        return y * y * y * a + 3 * x * y * y * near_a + 3 * x * x * y * near_b + x * x * x * b;
    }
};

// A Coons patch between four such sides.
struct Patch {
    std::array<Vector3f, 4> p;
    Side start, end, left, right;  // t = 0, t = 1, s = 0, s = 1
    Patch(const std::array<Vector3f, 4>& place, const std::array<Vector3f, 4>& n)
        : p(place),
          start(p[0], p[1], n[0], n[1]),
          end(p[3], p[2], n[3], n[2]),
          left(p[0], p[3], n[0], n[3]),
          right(p[1], p[2], n[1], n[2]) {}
    [[nodiscard]] Vector3f at(float s, float t) const {
        const Vector3f flat =
            (1 - t) * ((1 - s) * p[0] + s * p[1]) + t * ((1 - s) * p[3] + s * p[2]);
        return (1 - t) * start.at(s) + t * end.at(s) + (1 - s) * left.at(t) + s * right.at(t) -
               flat;
    }
};

template <class T>
T blend(const std::array<T, 4>& corner, float s, float t) {
    return (1 - t) * ((1 - s) * corner[0] + s * corner[1]) +
           t * ((1 - s) * corner[3] + s * corner[2]);
}

// Calls visit(s, t) for the vertices of a patch, rows of constant t.
template <class Visitor>
void for_patch(int level, Visitor&& visit) {
    const auto step = 1.0f / static_cast<float>(level);
    for (int j = 0; j <= level; ++j) {
        for (int i = 0; i <= level; ++i)
            visit(static_cast<float>(i) * step, static_cast<float>(j) * step);
    }
}

// Which sides of which quads end the paper: at its border, or torn, where the neighbour on the
// lattice is missing or has nodes of its own.
class Edges {
  public:
    explicit Edges(const SheetView& sheet) : sheet_(sheet), torn_node_(sheet.x.size()) {
        of_cell_.assign(static_cast<std::size_t>(sheet.row_count * sheet.column_count), kNone);
        for (std::size_t q = 0; q < sheet.quads.size(); ++q)
            of_cell_[static_cast<std::size_t>(first_site(q))] = static_cast<Index>(q);
        for (std::size_t q = 0; q < sheet.quads.size(); ++q) {
            for (std::size_t k = 0; k < 4; ++k) {
                if (side(q, k) != Side::Torn) continue;
                torn_node_[corner(q, k)] = torn_node_[corner(q, k + 1)] = 1;
            }
        }
    }

    [[nodiscard]] unsigned bits(std::size_t q) const {
        unsigned sides = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Side s = side(q, k);
            sides |= s == Side::Torn ? kTornSide << k : s == Side::Border ? kBorderSide << k : 0;
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool beside = (sides & (kTornSide << k | kTornSide << (k + 3) % 4)) != 0;
            if (torn_node_[corner(q, k)] != 0 && !beside) sides |= kTornCorner << k;
        }
        return sides;
    }

  private:
    enum class Side : std::uint8_t { Whole, Border, Torn };
    [[nodiscard]] Index first_site(std::size_t q) const { return sheet_.site[corner(q, 0)]; }
    [[nodiscard]] std::size_t corner(std::size_t q, std::size_t k) const {
        return static_cast<std::size_t>(sheet_.quads[q][k % 4]);
    }
    [[nodiscard]] Side side(std::size_t q, std::size_t k) const {
        constexpr std::array<std::array<Index, 2>, 4> kAway{{{-1, 0}, {0, 1}, {1, 0}, {0, -1}}};
        Index row = first_site(q) / sheet_.column_count + kAway[k][0];
        const Index column = first_site(q) % sheet_.column_count + kAway[k][1];
        if (sheet_.closed) row = (row + sheet_.row_count) % sheet_.row_count;
        const Index rows = sheet_.closed ? sheet_.row_count : sheet_.row_count - 1;
        if (row < 0 || row >= rows || column < 0 || column >= sheet_.column_count - 1)
            return Side::Border;
        const Index other = of_cell_[static_cast<std::size_t>(row * sheet_.column_count + column)];
        if (other == kNone) return Side::Torn;
        const auto o = static_cast<std::size_t>(other);
        const bool shared =
            corner(q, k) == corner(o, k + 3) && corner(q, k + 1) == corner(o, k + 2);
        return shared ? Side::Whole : Side::Torn;
    }

    const SheetView& sheet_;
    std::vector<Index> of_cell_;  // quad by its first site
    std::vector<char> torn_node_;
};

}  // namespace

int patch_level(std::size_t quads, double pixels) {
    const int most = quads <= 6000 ? 4 : quads <= 20000 ? 2 : 1;
    return std::clamp(static_cast<int>(pixels / 8.0), 1, most);
}

int shell_count(double pixels) {
    constexpr double kVisible = 1.5;  // [pixels]
    constexpr int kMost = 16;         // by then each is some pixels high, and soft with fibres
    return pixels < kVisible ? 1 : std::min(kMost, 1 + static_cast<int>(std::ceil(pixels)));
}

void append_vertices(const SheetView& sheet, const WorldView& world, int level,
                     std::span<const float> quantity, std::vector<SheetVertex>& vertices,
                     double ragged) {
    const std::vector<Vector3f> normals = node_normals(sheet);
    const auto shifts = edge_shifts(sheet, ragged);
    const std::vector<Vector3> torn = torn_positions(sheet, shifts);
    const SiteGrid cells = site_grid(sheet);
    const FieldGrid fields = make_field_grid(sheet, world);
    for (const Quad& quad : sheet.quads) {
        const Corners c = corners_of(quad);
        std::array<Vector3f, 4> places, n;
        std::array<float, 4> value{}, along{}, across{};  // along and across: shifts [cells]
        for (std::size_t k = 0; k < 4; ++k) {
            if (!shifts.empty()) {
                along[k] = static_cast<float>(1e3 * shifts[c[k]][0] / cells.along);
                across[k] = static_cast<float>(1e3 * shifts[c[k]][1] / cells.across);
            }
            places[k] = torn.empty() ? place(sheet, c[k]) : Vector3f(torn[c[k]].cast<float>());
            n[k] = normals[c[k]];
            if (!quantity.empty()) value[k] = quantity[c[k]];
        }
        const Patch patch(places, n);
        const Index row = sheet.site[c[0]] / sheet.column_count;
        const Index column = sheet.site[c[0]] % sheet.column_count;
        for_patch(level, [&](float s, float t) {
            const Vector3f p = patch.at(s, t), normal = blend(n, s, t).normalized();
            const SiteFields f =
                smooth_fields(fields, row, column, s + blend(along, s, t), t + blend(across, s, t));
            vertices.push_back({p.x(), p.y(), p.z(), normal.x(), normal.y(), normal.z(), f.charred,
                                f.burnt, f.age, f.temperature, blend(value, s, t)});
        });
    }
}

void append_points(const SheetView& sheet, std::size_t number, int level,
                   std::vector<SheetPoint>& points, double ragged) {
    const SiteGrid grid = site_grid(sheet);
    const auto along = static_cast<float>(grid.along), across = static_cast<float>(grid.across);
    const auto height = static_cast<float>(1e3 * sheet.height);
    const auto width = static_cast<float>(1e3 * sheet.width);
    const Edges edges(sheet);
    const auto shifts = edge_shifts(sheet, ragged);
    for (std::size_t q = 0; q < sheet.quads.size(); ++q) {
        const Index site = sheet.site[static_cast<std::size_t>(sheet.quads[q][0])];
        const Index site_row = site / sheet.column_count;
        const auto row = static_cast<float>(site_row);
        const auto column = static_cast<float>(site % sheet.column_count);
        const auto bits = static_cast<float>(edges.bits(q));
        std::array<float, 4> aside{}, below{};  // [mm]
        for (std::size_t k = 0; k < 4 && !shifts.empty(); ++k) {
            const auto& shift = shifts[static_cast<std::size_t>(sheet.quads[q][k])];
            aside[k] = static_cast<float>(1e3 * shift[0]);
            below[k] = static_cast<float>(1e3 * shift[1]);
        }
        for_patch(level, [&](float s, float t) {
            const float u = along * (column + s) + blend(aside, s, t);
            const float v = across * (row + t) + blend(below, s, t);
            points.push_back({u, v, s, t, along, across, v / width, u / height,
                              static_cast<float>(number), bits});
        });
    }
}

void append_triangles(std::size_t quads, int level, std::uint32_t first_vertex,
                      std::vector<std::uint32_t>& indices) {
    const auto side = static_cast<std::uint32_t>(level) + 1;
    for (std::size_t q = 0; q < quads; ++q) {
        const auto first = first_vertex + static_cast<std::uint32_t>(q) * side * side;
        for (std::uint32_t j = 0; j + 1 < side; ++j) {
            for (std::uint32_t i = 0; i + 1 < side; ++i) {
                const std::uint32_t a = first + j * side + i, b = a + 1, c = a + side + 1,
                                    d = a + side;
                for (const std::uint32_t index : {a, b, c, a, c, d})
                    indices.push_back(index);
            }
        }
    }
}

}  // namespace ember
