#include <limits>
#include <sstream>

#include "app/bench/bench_run.h"
#include "app/bench/stress_case.h"
#include "app/bench/work_problem.h"
#include "sim/lattice.h"
#include "sim/param_table.h"
#include "sim/topology.h"

namespace ember {
namespace {

// A small sheet over a strong lighter; later words overrule these.
constexpr const char* kSmallFire =
    "sheet.rows=6 sheet.columns=9 sheet.width=60 sheet.height=90 lighter.x=-30 lighter.y=356 "
    "lighter.rate=1000 lighter.strength=10 fire.heating_limit=1e5";

struct SetCorner {
    const char *name, *sets;
};

constexpr SetCorner kSetCorners[] = {
    {"plain", ""},
    {"all_held_by_edges", "sheet.columns=1 sheet.rows=9 sheet.held=both_main_ends"},
    {"nothing_held_without_gravity", "sheet.held=none world.gravity=0"},
    {"no_gravity", "world.gravity=0"},
    {"heaviest_gravity", "world.gravity=1000 world.held_gravity=1"},
    {"colder_ignition_than_air", "burning.ignition=-100"},
    {"lightest_paper", "paper.grammage=5"},
    {"heaviest_paper", "paper.grammage=5000"},
    {"thinnest_air_paper", "paper.density=50 paper.grammage=5"},
    {"densest_paper", "paper.density=5000"},
    {"worst_paper", "paper.c_s=1e-6"},
    {"best_paper", "paper.c_s=1"},
    {"thousandfold_fire", "fire.node_strength=100 fire.heating=1e7 fire.heating_limit=1e8"},
    {"densest_fire", "fire.emission=1e8 sheet.width=10 sheet.height=15 burning.ignition=20.5"},
    {"no_fire_from_nodes", "fire.emission=0"},
    {"fullest_lighter", "lighter.rate=1e5"},
    {"largest_shrinking", "shrinkage.factor=1e-6 shrinkage.floor=0.01"},
    {"largest_shrinking_by_halves", "shrinkage.factor=1e-6 shrinkage.rule=half"},
    {"shrinking_in_no_time", "shrinkage.reference_step=0.01"},
    {"lighter_inside_the_sheet", "lighter.x=0 lighter.y=400 lighter.radius=0"},
    {"widest_lighter", "lighter.radius=1000"},
    {"tube_of_three_rows", "sheet.shape=cylinder sheet.rows=3"},
    {"tube_of_one_ring", "sheet.shape=cylinder sheet.rows=3 sheet.columns=1"},
    {"stack_of_five", "sheet.count=5 sheet.gap=5"},
    {"five_sheets_in_one_place", "sheet.count=5 sheet.gap=0"},
    {"slowest_ticks", "numerics.tick_rate=1"},
    {"fastest_ticks", "numerics.tick_rate=100000"},
    {"fastest_burning", "burning.burn_rate=1e5 burning.burn_speed=100"},
    {"no_loss_of_mass", "burning.burn_rate=0"},
    {"almost_nothing_left", "burning.residual_mass=1 burning.burn_rate=1e4"},
    {"almost_nothing_left_and_stiff",
     "burning.residual_mass=1 burning.burn_rate=1e4 springs.follows_mass=false"},
    {"almost_all_left", "burning.residual_mass=99"},
    {"furthest_particles", "fire.kernel_radius=1000"},
    {"nearest_particles", "fire.kernel_radius=0.5"},
    {"thickest_air", "world.air_drag=1000 world.air_drag_tangential=1"},
    {"strongest_damping", "springs.damping=1e5"},
    {"no_springs", "springs.structural=0 springs.diagonal=0 springs.bending=0 springs.damping=0"},
    {"only_bending_springs", "springs.structural=0 springs.diagonal=0"},
    {"stiffest_springs", "springs.stiffness_scale=1e4"},
    {"softest_springs", "springs.stiffness_scale=0.01"},
    {"most_varied_springs", "springs.variation=90 springs.variation_pattern=per_spring"},
    {"strongest_wind_of_fire", "fire.force=100 fire.force_limit=1000"},
    {"coldest_air", "heat.ambient=-200"},
    {"air_hotter_than_flames", "heat.ambient=500 heat.flame_limit=0"},
    {"strongest_cooling", "heat.convection=1e5 heat.emissivity=1"},
    {"no_conduction", "paper.conductivity=0"},
    {"strongest_conduction", "paper.conductivity=10 paper.c_s=1e-6 numerics.heat_solver=adi"},
    {"smallest_heat_capacity", "paper.specific_heat=1"},
    {"smallest_sheet", "sheet.width=1 sheet.height=1"},
    {"largest_sheet", "sheet.width=10000 sheet.height=10000"},
    {"needle", "sheet.width=1 sheet.height=5000"},
    {"waviest_sheet", "sheet.imperfection=100"},
    {"lives_that_end_before_they_begin", "fire.life_min=1 fire.life_max=0.01"},
    {"largest_seed", "numerics.seed=9007199254740991"},
    {"finest_tolerance", "numerics.integrator=rkf78 numerics.tolerance=1e-13"},
    {"many_substeps", "numerics.substeps_min=1000"},
    {"everything_breaks",
     "fracture.threshold=0 fracture.relief_time=0 fracture.middle_burnt=false burning.ignition=-50 "
     "burning.burn_rate=1e4"},
    {"below_the_ground", "sheet.elevation=-10000"},
    {"dropped_stack",
     "sheet.elevation=60 sheet.held=none sheet.count=4 sheet.gap=10 "
     "sheet.pose=horizontal"},
    {"dropped_crumpling_stack",
     "sheet.elevation=40 sheet.held=none sheet.count=3 sheet.gap=5 sheet.pose=horizontal "
     "contact.self=true world.gravity=50 shrinkage.factor=1e-9 burning.ignition=21"},
    {"sheets_in_touch", "sheet.count=4 sheet.gap=1 contact.self=true"},
    {"sheets_closer_than_they_keep", "sheet.count=3 sheet.gap=0.1 contact.thickness=5"},
    {"thickest_contact",
     "sheet.count=3 sheet.gap=2 contact.thickness=20 contact.self=true "
     "sheet.elevation=10"},
    {"thinnest_contact",
     "sheet.count=3 sheet.gap=2 contact.thickness=0.01 sheet.elevation=20 "
     "sheet.held=none sheet.pose=horizontal paper.grammage=5"},
    {"stickiest_contact",
     "sheet.count=2 sheet.gap=1 contact.friction=10 sheet.held=none "
     "contact.ground_friction=10 sheet.elevation=30"},
    {"self_folding_tube",
     "sheet.shape=cylinder contact.self=true sheet.held=none "
     "sheet.elevation=20 world.gravity=100"},
    {"standing_on_edge", "sheet.elevation=91 sheet.held=none contact.self=true"},
    {"longest_contact_interval", "contact.interval=1 sheet.elevation=20 sheet.held=none"},
    {"shortest_contact_interval", "contact.interval=1e-5 sheet.elevation=20 sheet.held=none"},
    {"sleeping_on_the_ground", "sheet.elevation=1 sheet.held=none numerics.sleep_speed=1"}};

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

StressCase corner(const std::string& name, const std::string& sets = "") {
    StressCase c;
    c.name = name;
    c.sets = words_of(kSmallFire + (' ' + sets));
    c.ticks = 40;
    return c;
}

// Changes the state, and lets the ledgers know: the change is not the simulation's.
template <class Change>
std::function<void(World&)> edited(Change change) {
    return [change](World& world) {
        WorldState state = world.snapshot();
        for (std::size_t s = 0; s < state.sheets.size(); ++s)
            change(world, state, s);
        world.restore(std::move(state));
        static_cast<void>(world.apply(world.params()));
    };
}

void warm_to(const World& world, WorldState& state, std::size_t s, double temperature) {
    const PaperParams& paper = world.params().paper;
    SheetState& sheet = state.sheets[s];
    for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
        const double capacity = paper.c_s * paper.specific_heat * sheet.initial_mass[n];
        state.heat.given_fire += capacity * (temperature - sheet.temperature[n]);
        sheet.temperature[n] = temperature;
    }
}

void hold(SheetState& sheet, std::size_t first, std::size_t count) {
    for (std::size_t n = 0; n < sheet.held.size(); ++n)
        sheet.held[n] = n >= first && n < first + count;
    find_pieces(sheet);
}

void cut_everywhere(const World& world, SheetState& sheet, std::size_t s, bool both_ways) {
    const Params& p = world.params();
    const Lattice lattice = make_lattice(world.scene().sheets[s], p.paper, p.springs,
                                         static_cast<std::uint64_t>(p.numerics.seed), s);
    for (Index site = 0; site < lattice.site_count(); ++site) {
        cut_site(lattice, sheet, site, CutLine::AlongMain);
        if (both_ways) cut_site(lattice, sheet, site, CutLine::AlongCross);
    }
    find_pieces(sheet);
}

void add_edited(std::vector<StressCase>& cases) {
    const auto add = [&](const char* name, auto change) {
        cases.push_back(corner(name));
        cases.back().prepare = edited(change);
    };
    add("all_nodes_held", [](const World&, WorldState& state, std::size_t s) {
        hold(state.sheets[s], 0, state.sheets[s].held.size());
    });
    add("one_node_held",
        [](const World&, WorldState& state, std::size_t s) { hold(state.sheets[s], 35, 1); });
    add("everything_ignites_at_once", [](const World& world, WorldState& state, std::size_t s) {
        warm_to(world, state, s, 1100.0);
    });
    add("hotter_than_flames", [](const World& world, WorldState& state, std::size_t s) {
        warm_to(world, state, s, 5000.0);
    });
    add("cut_into_strips", [](const World& world, WorldState& state, std::size_t s) {
        cut_everywhere(world, state.sheets[s], s, false);
    });
    add("cut_into_quads", [](const World& world, WorldState& state, std::size_t s) {
        cut_everywhere(world, state.sheets[s], s, true);
    });
    add("glue_gone_but_nodes_shared", [](const World&, WorldState& state, std::size_t s) {
        SheetState& sheet = state.sheets[s];
        sheet.glue.assign(sheet.glue.size(), 0);
        ++sheet.topology_version;
    });
    add("spring_of_no_length", [](const World&, WorldState& state, std::size_t s) {
        state.sheets[s].position.set(35, state.sheets[s].position.at(36));
    });
    add("all_nodes_in_one_place", [](const World&, WorldState& state, std::size_t s) {
        Vector3Array& position = state.sheets[s].position;
        for (std::size_t n = 0; n < position.size(); ++n)
            position.set(n, position.at(35));
    });
    add("stretched_tenfold", [](const World&, WorldState& state, std::size_t s) {
        for (double& x : state.sheets[s].position.x)
            x *= 10;
    });
    add("fast_as_a_bullet", [](const World&, WorldState& state, std::size_t s) {
        state.sheets[s].velocity.set(35, {0, 0, 800});
    });
}

// Before every tick the next of `values` is given to the parameter `key`, in SI.
StressCase restless(const std::string& key, std::vector<double> values) {
    StressCase c = corner("restless_" + key);
    c.during = [key, values](World& world, int tick) {
        Params params = world.params();
        const ParamInfo& row = *find_param(sim_param_rows(), key);
        row.set(&params, values[static_cast<std::size_t>(tick) % values.size()]);
        static_cast<void>(world.apply(params));
    };
    return c;
}

}  // namespace

std::vector<StressCase> corner_cases() {
    std::vector<StressCase> cases;
    for (const SetCorner& c : kSetCorners)
        cases.push_back(corner(c.name, c.sets));
    for (const std::string& method : choices_of("numerics.integrator")) {
        cases.push_back(
            corner("unsafe_" + method, "numerics.safety=10 numerics.integrator=" + method));
    }
    add_edited(cases);
    cases.push_back(restless("world.gravity", {0, 1000}));
    cases.push_back(restless("world.held_gravity", {0, 1}));
    cases.push_back(restless("world.air_drag", {0, 1000}));
    cases.push_back(restless("numerics.integrator", {1, 2, 3, 4, 5, 6, 7}));
    cases.push_back(restless("numerics.heat_solver", {1, 2, 3}));
    cases.push_back(restless("numerics.arithmetic", {0, 1}));
    cases.push_back(restless("numerics.skip", {0, 1}));
    cases.push_back(restless("numerics.sleep_speed", {0, 1}));
    cases.push_back(restless("burning.burn_speed", {0.01, 100}));
    cases.push_back(restless("shrinkage.factor", {0, 1e-6}));
    cases.push_back(restless("heat.flame_limit", {1373.15, 273.15}));
    cases.push_back(restless("burning.ignition", {1041.15, 200}));
    cases.push_back(restless("fracture.threshold", {0, std::numeric_limits<double>::infinity()}));
    cases.push_back(restless("springs.follows_mass", {0, 1}));
    cases.push_back(restless("lighter.on", {0, 1}));
    cases.push_back(restless("lighter.y", {0.3, 0.5}));
    return cases;
}

}  // namespace ember
