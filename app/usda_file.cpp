#include "app/usda_file.h"

#include <Eigen/LU>
#include <algorithm>
#include <functional>

#include "app/preset_io/parameter_value.h"
#include "render/camera.h"

namespace ember {
namespace {

constexpr float kParticleWidth = 0.004f;  // [m]

// Values as the format writes them; nine digits are all that a float has.
void put(std::ostream& out, float value) {
    out << value;
}
void put(std::ostream& out, int value) {
    out << value;
}
void put(std::ostream& out, std::uint64_t value) {
    out << static_cast<std::int64_t>(value);
}
template <std::size_t N>
void put(std::ostream& out, const std::array<float, N>& value) {
    for (std::size_t i = 0; i < N; ++i)
        out << (i == 0 ? "(" : ", ") << value[i];
    out << ')';
}
template <class T>
void put(std::ostream& out, const std::vector<T>& values) {
    out << '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) out << ", ";
        put(out, values[i]);
    }
    out << ']';
}

// An attribute with a value per frame.
class Samples {
  public:
    Samples(std::ostream& out, const UsdaScene& scene) : out_(out), scene_(scene) {}

    template <class Get>
    void operator()(const std::string& declaration, const std::string& metadata, Get&& get) const {
        if (!metadata.empty()) out_ << "        " << declaration << " (" << metadata << ")\n";
        out_ << "        " << declaration << ".timeSamples = {\n";
        for (std::size_t f = 0; f < scene_.frames.size(); ++f) {
            out_ << "            " << scene_.numbers[f] << ": ";
            put(out_, get(scene_.frames[f]));
            out_ << ",\n";
        }
        out_ << "        }\n";
    }

  private:
    std::ostream& out_;
    const UsdaScene& scene_;
};

using Extent = std::vector<std::array<float, 3>>;

Extent extent_of(const std::vector<std::array<float, 3>>& points, float margin) {
    if (points.empty()) return {{0, 0, 0}, {0, 0, 0}};
    Extent box{points.front(), points.front()};
    for (const auto& point : points) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box[0][axis] = std::min(box[0][axis], point[axis] - margin);
            box[1][axis] = std::max(box[1][axis], point[axis] + margin);
        }
    }
    return box;
}

std::vector<int> indices_of(const MeshFrame& mesh) {
    std::vector<int> indices;
    for (const auto& quad : mesh.quads)
        indices.insert(indices.end(), quad.begin(), quad.end());
    return indices;
}

std::vector<std::array<float, 2>> corners_of(const MeshFrame& mesh) {
    std::vector<std::array<float, 2>> all;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        for (std::size_t c = 0; c < 4; ++c)
            all.push_back(corner_uv(mesh, q, c));
    }
    return all;
}

void put_mesh(std::ostream& out, const UsdaScene& scene, std::size_t s) {
    const Samples samples(out, scene);
    const MeshFrame& first = scene.frames.front().sheets[s];
    const bool constant =
        std::all_of(scene.frames.begin(), scene.frames.end(),
                    [&](const KeptFrame& frame) { return frame.sheets[s].quads == first.quads; });
    out << "\n    def Mesh \"Sheet_" << s + 1
        << "\"\n    {\n        uniform token subdivisionScheme = \"none\"\n"
           "        uniform bool doubleSided = 1\n        int[] faceVertexCounts = ";
    put(out, std::vector<int>(first.quads.size(), 4));
    out << '\n';
    if (constant) {
        out << "        int[] faceVertexIndices = ";
        put(out, indices_of(first));
        out << '\n';
    } else {
        samples("int[] faceVertexIndices", "",
                [s](const KeptFrame& frame) { return indices_of(frame.sheets[s]); });
    }
    out << "        texCoord2f[] primvars:st = ";
    put(out, corners_of(first));
    out << " (interpolation = \"faceVarying\")\n";
    samples("point3f[] points", "", [s](const KeptFrame& frame) { return frame.sheets[s].points; });
    samples("float3[] extent", "",
            [s](const KeptFrame& frame) { return extent_of(frame.sheets[s].points, 0); });
    const std::string vertex = "interpolation = \"vertex\"";
    samples("float[] primvars:temperature", vertex,
            [s](const KeptFrame& frame) { return frame.sheets[s].temperature; });
    samples("float[] primvars:mass", vertex,
            [s](const KeptFrame& frame) { return frame.sheets[s].mass; });
    samples("int[] primvars:phase", vertex,
            [s](const KeptFrame& frame) { return frame.sheets[s].phase; });
    samples("float[] primvars:age", vertex,
            [s](const KeptFrame& frame) { return frame.sheets[s].age; });
    out << "    }\n";
}

void put_particles(std::ostream& out, const UsdaScene& scene) {
    const Samples samples(out, scene);
    out << "\n    def Points \"Fire\"\n    {\n";
    samples("point3f[] points", "", [](const KeptFrame& frame) { return frame.particles.points; });
    samples("float[] widths", "", [](const KeptFrame& frame) {
        return std::vector<float>(frame.particles.points.size(), kParticleWidth);
    });
    samples("float3[] extent", "", [](const KeptFrame& frame) {
        return extent_of(frame.particles.points, kParticleWidth / 2);
    });
    samples("int64[] ids", "", [](const KeptFrame& frame) { return frame.particles.ids; });
    const std::string vertex = "interpolation = \"vertex\"";
    samples("float[] primvars:temperature", vertex,
            [](const KeptFrame& frame) { return frame.particles.temperature; });
    samples("float[] primvars:age", vertex,
            [](const KeptFrame& frame) { return frame.particles.age; });
    out << "    }\n";
}

// The format multiplies row vectors, so its matrix is the transpose of ours.
void put_matrix(std::ostream& out, const Eigen::Matrix4f& matrix) {
    for (int column = 0; column < 4; ++column) {
        out << (column == 0 ? "( (" : ", (");
        for (int row = 0; row < 4; ++row)
            out << (row == 0 ? "" : ", ") << matrix(row, column);
        out << ')';
    }
    out << " )";
}

void put_camera(std::ostream& out, const UsdaScene& scene) {
    constexpr float kWidth = 0.36f;  // film 36 mm wide, in tenths of the unit as the format has it
    out << "\n    def Camera \"Camera\"\n    {\n        float horizontalAperture = " << kWidth
        << "\n        float verticalAperture = "
        << kWidth * static_cast<float>(scene.cameras.front().height) /
               static_cast<float>(scene.cameras.front().width)
        << "\n        float2 clippingRange = (0.01, 100)\n"
           "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n";
    const auto camera_of = [](const CameraFrame& frame) {
        return make_camera(frame.params, frame.width, frame.height);
    };
    out << "        float focalLength.timeSamples = {\n";
    for (std::size_t f = 0; f < scene.cameras.size(); ++f) {
        const CameraFrame& frame = scene.cameras[f];
        const float high =
            kWidth * static_cast<float>(frame.height) / static_cast<float>(frame.width);
        out << "            " << scene.numbers[f] << ": "
            << high / 2 / camera_of(frame).tan_half_fov << ",\n";
    }
    out << "        }\n        matrix4d xformOp:transform.timeSamples = {\n";
    for (std::size_t f = 0; f < scene.cameras.size(); ++f) {
        out << "            " << scene.numbers[f] << ": ";
        put_matrix(out, camera_of(scene.cameras[f]).view.inverse());
        out << ",\n";
    }
    out << "        }\n    }\n";
}

}  // namespace

void write_usda(std::ostream& out, const UsdaScene& scene) {
    out.precision(9);
    out << "#usda 1.0\n(\n    defaultPrim = \"Emberleaf\"\n    doc = " << quoted(scene.comment)
        << "\n    metersPerUnit = 1\n    upAxis = \"Y\"\n    timeCodesPerSecond = "
        << number_text(scene.fps) << "\n    framesPerSecond = " << number_text(scene.fps)
        << "\n    startTimeCode = " << scene.numbers.front()
        << "\n    endTimeCode = " << scene.numbers.back() << "\n)\n\ndef Xform \"Emberleaf\"\n{";
    for (std::size_t s = 0; s < scene.frames.front().sheets.size(); ++s)
        put_mesh(out, scene, s);
    if (scene.particles) put_particles(out, scene);
    put_camera(out, scene);
    out << "}\n";
}

}  // namespace ember
