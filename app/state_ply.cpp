#include "app/state_ply.h"

#include <sstream>

#include "app/value_bytes.h"
#include "sim/units.h"

namespace ember {
namespace {

// Where the sheet has no paper there is no node either.
bool is_there(const SheetView& sheet, std::size_t node) {
    return sheet.initial_mass[node] > 0;
}

std::string header(const WorldView& world) {
    std::size_t nodes = 0, quads = 0;
    for (const SheetView& sheet : world.sheets) {
        for (std::size_t n = 0; n < sheet.x.size(); ++n)
            nodes += is_there(sheet, n) ? 1u : 0u;
        quads += sheet.quads.size();
    }
    std::ostringstream out;
    out << "ply\nformat binary_little_endian 1.0\ncomment emberleaf, t = " << world.time
        << " s\nelement vertex " << nodes << '\n';
    for (const char* name : {"x", "y", "z", "vx", "vy", "vz", "temperature", "mass"}) {
        out << "property double " << name << '\n';
    }
    out << "property uchar phase\nproperty int sheet\nproperty int row\nproperty int column\n"
        << "element face " << quads << "\nproperty list uchar int vertex_indices\nend_header\n";
    return out.str();
}

void put_nodes(std::string& bytes, const SheetView& sheet, std::size_t number) {
    for (std::size_t n = 0; n < sheet.x.size(); ++n) {
        if (!is_there(sheet, n)) continue;
        for (const double value :
             {sheet.x[n], sheet.y[n], sheet.z[n], sheet.vx[n], sheet.vy[n], sheet.vz[n],
              unit::celsius.from_si(sheet.temperature[n]), sheet.mass[n]}) {
            put(bytes, value);
        }
        put(bytes, static_cast<std::uint8_t>(sheet.phase[n]));
        put(bytes, static_cast<std::int32_t>(number));
        put(bytes, static_cast<std::int32_t>(sheet.site[n] / sheet.column_count));
        put(bytes, static_cast<std::int32_t>(sheet.site[n] % sheet.column_count));
    }
}

}  // namespace

std::string state_ply(const WorldView& world) {
    std::string bytes = header(world);
    for (std::size_t s = 0; s < world.sheets.size(); ++s)
        put_nodes(bytes, world.sheets[s], s);
    Index next = 0;
    std::vector<Index> vertex;
    for (const SheetView& sheet : world.sheets) {
        vertex.clear();
        for (std::size_t n = 0; n < sheet.x.size(); ++n)
            vertex.push_back(is_there(sheet, n) ? next++ : kNone);
        for (const Quad& quad : sheet.quads) {
            put(bytes, std::uint8_t{4});
            for (const Index node : quad)
                put(bytes, vertex[static_cast<std::size_t>(node)]);
        }
    }
    return bytes;
}

}  // namespace ember
