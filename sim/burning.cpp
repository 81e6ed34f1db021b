#include "sim/burning.h"

namespace ember {

double update_phases(const Params& params, double time, double dt, SheetState& sheet,
                     std::vector<Index>& burnt_out, StepCounters& counters) {
    const BurningParams& burning = params.burning;
    double gone = 0.0;
    for (std::size_t n = 0; n < sheet.phase.size(); ++n) {
        if (sheet.phase[n] == Phase::Unburnt) {
            if (sheet.temperature[n] < burning.ignition || sheet.held[n] != 0) continue;
            sheet.phase[n] = Phase::Burning;
            sheet.ignition_time[n] = time;
            ++counters.nodes_ignited;
        } else if (sheet.phase[n] == Phase::Burning) {
            const double area = sheet.initial_mass[n] / params.paper.grammage;
            const double residue = burning.residual_mass * sheet.initial_mass[n];
            const double left = sheet.mass[n] - burning.burn_rate * area * dt;
            const double after = left > residue ? left : residue;
            gone += sheet.mass[n] - after;
            sheet.mass[n] = after;
            if (left > residue) {
                ++counters.nodes_burning;
                continue;
            }
            sheet.phase[n] = Phase::BurntOut;
            sheet.burnout_time[n] = time;
            burnt_out.push_back(sheet.site[n]);
            ++counters.nodes_burnt_out;
        }
    }
    return gone;
}

}  // namespace ember
