#include <algorithm>

#include "app/checkpoint_format.h"

namespace ember {
namespace {

bool sizes_are(std::size_t size, std::initializer_list<std::size_t> sizes) {
    return std::ranges::all_of(sizes, [&](std::size_t s) { return s == size; });
}

bool below(const std::vector<Index>& indices, std::size_t end) {
    return std::ranges::all_of(
        indices, [&](Index i) { return i >= 0 && static_cast<std::size_t>(i) < end; });
}

// Arrays over sites that are there or not.
bool all_or_none(std::size_t sites, std::initializer_list<std::size_t> sizes) {
    return sizes_are(sites, sizes) || sizes_are(0, sizes);
}

bool fits(const SheetState& sheet, const SheetState& like) {
    const std::size_t nodes = sheet.mass.size(), sites = like.glue.size();
    const Vector3Array &p = sheet.position, &v = sheet.velocity;
    const CrackPaths& cracks = sheet.cracks;
    const RestCurvature& rest = sheet.rest_curvature;
    const auto known = [&](Index node) {
        return node == kNone || (node >= 0 && static_cast<std::size_t>(node) < nodes);
    };
    return nodes >= sites &&
           sizes_are(nodes,
                     {p.x.size(), p.y.size(), p.z.size(), v.x.size(), v.y.size(), v.z.size(),
                      sheet.temperature.size(), sheet.initial_mass.size(),
                      sheet.ignition_time.size(), sheet.burnout_time.size(), sheet.phase.size(),
                      sheet.site.size(), sheet.held.size(), sheet.piece_held.size()}) &&
           sizes_are(sites, {sheet.glue.size(), sheet.relief_until.size()}) &&
           sheet.quiet_ticks.size() == like.quiet_ticks.size() &&
           sheet.rest_length.size() == like.rest_length.size() &&
           sheet.quads.size() == like.quads.size() &&
           all_or_none(sites,
                       {cracks.offset_x.size(), cracks.offset_z.size(), cracks.heading_x.size(),
                        cracks.heading_z.size(), cracks.due.size()}) &&
           below(cracks.tips, sites) &&
           sizes_are(like.rest_curvature.main.size(),
                     {rest.main.size(), rest.cross.size(), rest.twist.size()}) &&
           sizes_are(like.faces.heat.size(), {sheet.faces.heat.size(), sheet.faces.charred.size(),
                                              sheet.faces.progress.size()}) &&
           below(sheet.site, sites) && std::ranges::all_of(sheet.quads, [&](const Quad& quad) {
               return std::ranges::all_of(quad, known);
           });
}

}  // namespace

std::string misfit(const WorldState& state, const WorldState& like) {
    if (state.sheets.size() != like.sheets.size()) return "another number of sheets";
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        if (!fits(state.sheets[s], like.sheets[s]))
            return "sheet " + std::to_string(s + 1) + " is another one";
    }
    const std::size_t particles = state.fire.size();
    bool whole = true;
    for_each_array(const_cast<FireState&>(state.fire),
                   [&](const auto& array) { whole = whole && array.size() == particles; });
    return whole ? "" : "particles without all that they have";
}

}  // namespace ember
