#include <array>
#include <limits>

#include "app/bench/stress_case.h"
#include "app/bench/work_problem.h"
#include "sim/random.h"

namespace ember {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Fault {
    const char* name;
    std::vector<double>& (*array)(WorldState&);
    double value;
};

SheetState& sheet_of(WorldState& state) {
    return state.sheets.front();
}

constexpr Fault kFaults[] = {
    {"velocity_nan", [](WorldState& s) -> auto& {return sheet_of(s).velocity.x;
}  // namespace
, kNaN
}  // namespace ember
, {"velocity_infinite", [](WorldState& s) -> auto& {return sheet_of(s).velocity.y;
}
, kInfinity
}
, {"velocity_1e30", [](WorldState& s) -> auto& {return sheet_of(s).velocity.z;
}
, 1e30
}
, {"velocity_1e200", [](WorldState& s) -> auto& {return sheet_of(s).velocity.z;
}
, -1e200
}
, {"position_nan", [](WorldState& s) -> auto& {return sheet_of(s).position.z;
}
, kNaN
}
, {"position_infinite", [](WorldState& s) -> auto& {return sheet_of(s).position.x;
}
, -kInfinity
}
, {"position_1e30", [](WorldState& s) -> auto& {return sheet_of(s).position.y;
}
, 1e30
}
, {"temperature_nan", [](WorldState& s) -> auto& {return sheet_of(s).temperature;
}
, kNaN
}
, {"temperature_infinite", [](WorldState& s) -> auto& {return sheet_of(s).temperature;
}
, kInfinity
}
, {"temperature_1e30", [](WorldState& s) -> auto& {return sheet_of(s).temperature;
}
, 1e30
}
, {"mass_nan", [](WorldState& s) -> auto& {return sheet_of(s).mass;
}
, kNaN
}
, {"mass_zero", [](WorldState& s) -> auto& {return sheet_of(s).mass;
}
, 0.0
}
, {"rest_length_nan", [](WorldState& s) -> auto& {return sheet_of(s).rest_length;
}
, kNaN
}
, {"rest_length_1e30", [](WorldState& s) -> auto& {return sheet_of(s).rest_length;
}
, 1e30
}
, {"particle_position_nan", [](WorldState& s) -> auto& {return s.fire.position.y;
}
, kNaN
}
, {"particle_velocity_nan", [](WorldState& s) -> auto& {return s.fire.velocity.x;
}
, kNaN
}
, {
    "particle_temperature_nan", [](WorldState & s) -> auto& {
        return s.fire.temperature;
    }
    , kNaN
}
}
;

constexpr std::size_t kColumns = 9;  // cells

// Some ticks with a lighter, so that there are particles, then the fault in the last tenth of the
// array: far from the held edge, and among the particles that live on.
void plant(World& world, const Fault& fault, std::uint64_t bits) {
    for (int tick = 0; tick < 12; ++tick) {
        if (!world.step().ok()) return;
    }
    WorldState state = world.snapshot();
    std::vector<double>& array = fault.array(state);
    const std::size_t tail = array.size() / 10 + 1;
    std::size_t at = array.size() - 1 - bits % tail;
    if (&array == &sheet_of(state).rest_length) at = bits % kColumns;  // along the first row
    while (array.size() == sheet_of(state).held.size() && sheet_of(state).held[at] != 0)
        at = (at + 1) % array.size();
    array[at] = fault.value;
    world.restore(std::move(state));
}

}  // namespace

std::vector<StressCase> fault_cases(std::size_t count, std::uint64_t seed) {
    const std::vector<std::string> methods = choices_of("numerics.integrator");
    std::vector<StressCase> cases;
    for (std::size_t i = 0; i < count; ++i) {
        const Fault& fault = kFaults[i % std::size(kFaults)];
        const std::string& method = methods[i / std::size(kFaults) % methods.size()];
        const std::uint64_t bits = mix(mix(seed) ^ i);
        StressCase c;
        c.name = "fault_" + std::to_string(i) + '_' + fault.name + '_' + method;
        c.sets = {"sheet.rows=6", "sheet.columns=" + std::to_string(kColumns), "lighter.y=140",
                  "numerics.integrator=" + method, "numerics.seed=" + std::to_string(bits % 1000)};
        c.ticks = 1;
        c.demand = StressDemand::Stops;
        c.prepare = [&fault, bits](World& world) { plant(world, fault, bits >> 10); };
        cases.push_back(c);
    }
    return cases;
}

std::vector<StressCase> rollback_cases() {
    std::vector<StressCase> cases;
    for (const std::string& method : choices_of("numerics.integrator")) {
        for (const char* safety : {"1.5", "2.5", "4"}) {
            StressCase c;
            c.name = "rollback_" + method + "_" + safety;
            c.sets = {"sheet.rows=6",
                      "sheet.columns=9",
                      "world.held_gravity=1",
                      "sheet.pose=horizontal",
                      "lighter.on=false",
                      "springs.damping=0",
                      "numerics.integrator=" + method,
                      "numerics.tick_rate=20",
                      std::string("numerics.safety=") + safety};
            c.ticks = 60;
            c.demand = StressDemand::RollsBack;
            cases.push_back(c);
        }
    }
    return cases;
}

}  // namespace ember
