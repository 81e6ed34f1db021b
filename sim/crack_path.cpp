#include "sim/crack_path.h"

#include <cmath>

namespace ember {

PlaneVector edge_vector(const Lattice& lattice, int direction) {
    const double hx = lattice.column_spacing, hz = lattice.row_spacing;
    if (direction % 2 == 0) return {direction == 0 ? hx : -hx, 0.0};
    return {0.0, direction == 1 ? hz : -hz};
}

CrackStep next_step(const Lattice& lattice, unsigned allowed, PlaneVector offset,
                    PlaneVector heading) {
    CrackStep best;
    double least = 0;
    for (int d = 0; d < 4; ++d) {
        const PlaneVector edge = edge_vector(lattice, d);
        if ((allowed >> d & 1u) == 0 || !(dot(edge, heading) > 0)) continue;
        const PlaneVector way{edge.x - offset.x, edge.z - offset.z};
        const double advance = dot(way, heading);
        const double aside = std::abs(way.x * heading.z - way.z * heading.x);
        if (best.edge >= 0 && aside >= least) continue;
        least = aside;
        best = {d, {advance * heading.x - way.x, advance * heading.z - way.z}, advance};
    }
    return best;
}

bool is_tip(const CrackPaths& cracks, Index site) {
    if (cracks.due.empty()) return false;
    const auto s = static_cast<std::size_t>(site);
    return cracks.heading_x[s] != 0 || cracks.heading_z[s] != 0;
}

void put_tip(const Lattice& lattice, Index site, const CrackStep& step, PlaneVector heading,
             double due, CrackPaths& cracks) {
    const Index tip = lattice.neighbour(site, step.edge);
    if (tip == kNone || is_tip(cracks, tip)) return;
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    if (cracks.due.empty()) {
        for (std::vector<double>* array : {&cracks.offset_x, &cracks.offset_z, &cracks.heading_x,
                                           &cracks.heading_z, &cracks.due})
            array->assign(sites, 0.0);
    }
    const auto t = static_cast<std::size_t>(tip);
    if (cracks.offset_x[t] == 0 && cracks.offset_z[t] == 0)
        cracks.offset_x[t] = step.offset.x, cracks.offset_z[t] = step.offset.z;
    cracks.heading_x[t] = heading.x, cracks.heading_z[t] = heading.z;
    cracks.due[t] = due;
    cracks.tips.push_back(tip);
}

PlaneVector crack_offset(const CrackPaths& cracks, Index site) {
    if (cracks.due.empty()) return {};
    const auto s = static_cast<std::size_t>(site);
    return {cracks.offset_x[s], cracks.offset_z[s]};
}

}  // namespace ember
