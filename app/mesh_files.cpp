#include "app/mesh_files.h"

#include <sstream>

#include "app/value_bytes.h"

namespace ember {

std::string mesh_ply(const MeshFrame& mesh) {
    std::ostringstream head;
    head << "ply\nformat binary_little_endian 1.0\ncomment emberleaf\nelement vertex "
         << mesh.points.size() << '\n';
    for (const char* name : {"x", "y", "z", "s", "t", "temperature", "mass", "age"})
        head << "property float " << name << '\n';
    head << "property uchar phase\nelement face " << mesh.quads.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    std::string bytes = head.str();
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
        for (const float value : mesh.points[n])
            put(bytes, value);
        for (const float value : mesh.uv[n])
            put(bytes, value);
        put(bytes, mesh.temperature[n]);
        put(bytes, mesh.mass[n]);
        put(bytes, mesh.age[n]);
        put(bytes, static_cast<std::uint8_t>(mesh.phase[n]));
    }
    for (const auto& quad : mesh.quads) {
        put(bytes, std::uint8_t{4});
        for (const int corner : quad)
            put(bytes, static_cast<std::int32_t>(corner));
    }
    return bytes;
}

std::string mesh_obj(const MeshFrame& mesh) {
    std::ostringstream out;
    out.precision(9);
    out << "# emberleaf; metres, y upwards\no paper\n";
    for (const auto& p : mesh.points)
        out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        for (std::size_t c = 0; c < 4; ++c) {
            const auto uv = corner_uv(mesh, q, c);
            out << "vt " << uv[0] << ' ' << uv[1] << '\n';
        }
    }
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        out << 'f';
        for (std::size_t c = 0; c < 4; ++c)
            out << ' ' << mesh.quads[q][c] + 1 << '/' << 4 * q + c + 1;
        out << '\n';
    }
    return out.str();
}

std::string point_cache(std::span<const MeshFrame> frames, float first) {
    std::string bytes("POINTCACHE2\0", 12);
    put(bytes, std::int32_t{1});  // version
    put(bytes, static_cast<std::int32_t>(frames.front().points.size()));
    put(bytes, first);
    put(bytes, 1.0f);  // frames between samples
    put(bytes, static_cast<std::int32_t>(frames.size()));
    for (const MeshFrame& frame : frames) {
        for (const auto& point : frame.points) {
            for (const float value : point)
                put(bytes, value);
        }
    }
    return bytes;
}

}  // namespace ember
