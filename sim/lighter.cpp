#include "sim/lighter.h"

#include "sim/param_table.h"

namespace ember {

std::vector<LighterParams> lighters_of(const Params& params) {
    if (params.lighters.empty()) return {params.lighter};
    std::vector<LighterParams> lighters;
    for (const ParamOverrides& overrides : params.lighters) {
        Params one;
        one.lighter = params.lighter;
        for (const ParamOverride& o : overrides)
            o.row->assign(&one, o.value);
        lighters.push_back(one.lighter);
    }
    return lighters;
}

void set_lighter(Params& params, std::size_t number, const LighterParams& lighter) {
    if (params.lighters.empty()) {
        params.lighter = lighter;
        return;
    }
    Params before, after;
    before.lighter = lighters_of(params)[number];
    after.lighter = lighter;
    for (const ParamInfo& row : sim_param_rows()) {
        if (row.group() != "lighter" || row.value(&before) == row.value(&after)) continue;
        put_override(params.lighters[number], row, row.value(&after));
    }
}

bool lighter_lit(const LighterParams& lighter, double time, double dt) {
    return lighter.on && time + dt > lighter.start && time < lighter.start + lighter.duration;
}

Vector3 lighter_position(const LighterParams& lighter, double time) {
    const auto place = [](const std::array<double, 4>& key) {
        return Vector3(key[1], key[2], key[3]);
    };
    if (lighter.path.empty()) return {lighter.x, lighter.y, lighter.z};
    if (time <= lighter.path.front()[0]) return place(lighter.path.front());
    for (std::size_t i = 1; i < lighter.path.size(); ++i) {
        const auto &from = lighter.path[i - 1], &to = lighter.path[i];
        if (time >= to[0]) continue;
        const double share = (time - from[0]) / (to[0] - from[0]);
        return place(from) + share * (place(to) - place(from));
    }
    return place(lighter.path.back());
}

std::vector<LighterView> view_lighters(const std::vector<LighterParams>& lighters, double time,
                                       double dt) {
    std::vector<LighterView> views;
    for (const LighterParams& lighter : lighters)
        views.push_back({lighter_position(lighter, time), lighter_lit(lighter, time, dt)});
    return views;
}

}  // namespace ember
