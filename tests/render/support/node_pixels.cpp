#include "support/node_pixels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ember::test {
namespace {

using Eigen::Vector3f;

constexpr float kSameDepth = 0.002f;  // [m] two layers of the sheet are further apart

// Distance [m] from the camera of the nearest surface in every pixel, infinite where there is none.
struct DepthPicture {
    int width, height;
    std::vector<float> depth;

    [[nodiscard]] float at(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return std::numeric_limits<float>::max();
        return depth[static_cast<std::size_t>(y * width + x)];
    }
};

// A point as (pixel x, pixel y, 1 / distance): what is linear across a triangle in a picture.
Vector3f on_screen(const Camera& camera, const Vector3f& point, int width, int height) {
    const Vector3f pixel = project(camera, point, width, height);
    const float distance = -(camera.view * point.homogeneous()).z();
    return {pixel.x(), pixel.y(), 1.0f / distance};
}

void fill(DepthPicture& picture, const std::array<Vector3f, 3>& p) {
    const auto cross = [](const Vector3f& a, const Vector3f& b, float x, float y) {
        return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
    };
    const float area = cross(p[0], p[1], p[2].x(), p[2].y());
    if (area == 0) return;
    const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int y = std::max(0, int(top)); y <= std::min(picture.height - 1, int(bottom)); ++y) {
        for (int x = std::max(0, int(left)); x <= std::min(picture.width - 1, int(right)); ++x) {
            const float cx = static_cast<float>(x) + 0.5f, cy = static_cast<float>(y) + 0.5f;
            const float a = cross(p[1], p[2], cx, cy) / area, b = cross(p[2], p[0], cx, cy) / area;
            if (a < 0 || b < 0 || a + b > 1) continue;
            float& depth = picture.depth[static_cast<std::size_t>(y * picture.width + x)];
            const float inverse = a * p[0].z() + b * p[1].z() + (1 - a - b) * p[2].z();
            depth = std::min(depth, 1.0f / inverse);
        }
    }
}

Vector3f place(const SheetView& sheet, Index node) {
    const auto n = static_cast<std::size_t>(node);
    return Eigen::Vector3d(sheet.x[n], sheet.y[n], sheet.z[n]).cast<float>();
}

}  // namespace

std::vector<NodePixel> visible_nodes(const WorldView& world, const Camera& camera, int width,
                                     int height) {
    const SheetView& sheet = world.sheets.at(0);
    DepthPicture picture{width, height,
                         std::vector<float>(static_cast<std::size_t>(width * height),
                                            std::numeric_limits<float>::max())};
    const auto seen = [&](Index node) {
        return on_screen(camera, place(sheet, node), width, height);
    };
    for (const Quad& q : sheet.quads) {
        fill(picture, {seen(q[0]), seen(q[1]), seen(q[2])});
        fill(picture, {seen(q[0]), seen(q[2]), seen(q[3])});
    }
    std::vector<NodePixel> nodes;
    for (std::size_t n = 0; n < sheet.x.size(); ++n) {
        const Vector3f s = seen(static_cast<Index>(n));
        const int x = static_cast<int>(std::floor(s.x())), y = static_cast<int>(std::floor(s.y()));
        bool clear = true;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                // a slanted surface comes nearer from pixel to pixel; a layer in front by far more
                clear = clear && std::abs(picture.at(x + dx, y + dy) - 1.0f / s.z()) < kSameDepth;
            }
        }
        if (clear) nodes.push_back({n, x, y});
    }
    return nodes;
}

Colour linear_colour(const Image& image, int x, int y) {
    const std::size_t at = 4 * static_cast<std::size_t>(y * image.width + x);
    const auto decode = [&](std::size_t channel) {
        const float v = static_cast<float>(image.rgba[at + channel]) / 255.0f;
        return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
    };
    return {decode(0), decode(1), decode(2)};
}

float distance_from_shaded(const Colour& seen, const Colour& flat) {
    const float shade = std::clamp(seen.dot(flat) / flat.squaredNorm(), 0.5f, 1.02f);
    return (seen - shade * flat).norm() / flat.norm();
}

double share(const std::vector<NodePixel>& nodes,
             const std::function<bool(std::size_t node)>& counts,
             const std::function<bool(const NodePixel&)>& fits) {
    int all = 0, good = 0;
    for (const NodePixel& n : nodes) {
        if (!counts(n.node)) continue;
        ++all;
        good += fits(n) ? 1 : 0;
    }
    return all > 0 ? static_cast<double>(good) / all : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ember::test
