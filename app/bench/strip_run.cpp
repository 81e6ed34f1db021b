#include "app/bench/strip_run.h"

#include <algorithm>
#include <cmath>

#include "app/bench/bench_run.h"
#include "app/run_options.h"
#include "sim/heat_conduction.h"
#include "sim/lattice.h"
#include "sim/world.h"

namespace ember {
namespace {

constexpr double kStiffEnough = 160;  // scale of a sheet that hardly stretches; more costs time
constexpr double kWidth = 0.100, kLength = 0.300;  // [m]
constexpr double kLit = 0.025;                     // [m] alight from the start
constexpr double kHotter = 100;                    // [K] than ignition, so that it does ignite
constexpr double kFrom = 0.30, kTo = 0.80;         // [1] of the length, measured between
constexpr double kSlowest = 0.1e-3;                // [kg/(m s)] what is slower than this has died

Params strip_params(Params p, Spread spread, double cell) {
    const Border border = p.sheet.border;
    const double imperfection = p.sheet.imperfection;
    p.sheet = {};
    p.sheets.clear();
    p.lighters.clear();
    p.wind = {};
    p.sheet.border = border;
    p.sheet.imperfection = imperfection;
    p.sheet.width = kWidth;
    p.sheet.height = kLength;
    p.sheet.rows = static_cast<int>(std::lround(kWidth / cell));
    p.sheet.columns = static_cast<int>(std::lround(kLength / cell));
    p.sheet.held = HeldEdge::BothCrossEnds;
    p.sheet.pose = spread == Spread::Horizontal ? SheetPose::Horizontal : SheetPose::Hanging;
    p.sheet.elevation = 0.5;
    p.lighter.on = false;
    p.plate = {};  // what is held flat does not bend, nor hang
    p.curl = {};
    p.springs.stiffness_scale = std::min(p.springs.stiffness_scale, kStiffEnough);
    return p;
}

// A node of the middle half of the width.
struct Place {
    std::size_t node;
    double distance;  // [m] from the lit edge
};

bool in_part(double distance) {
    constexpr double kRounding = 1e-9;  // [m]
    return distance > kFrom * kLength - kRounding && distance < kTo * kLength + kRounding;
}

// A hanging strip's first column is its upper edge.
double distance_of(Spread spread, const SheetParams& sheet, int column) {
    return sheet.height * (spread == Spread::Up ? sheet.columns - column : column) / sheet.columns;
}

std::vector<Place> middle_of(const SheetParams& sheet, Spread spread) {
    std::vector<Place> places;
    for (int row = (sheet.rows + 3) / 4; 4 * row <= 3 * sheet.rows; ++row) {
        for (int column = 0; column <= sheet.columns; ++column) {
            places.push_back({static_cast<std::size_t>(row * (sheet.columns + 1) + column),
                              distance_of(spread, sheet, column)});
        }
    }
    return places;
}

void light_edge(World& world, Spread spread) {
    const Params& p = world.params();
    WorldState state = world.snapshot();
    SheetState& sheet = state.sheets[0];
    for (std::size_t n = 0; n < sheet.site.size(); ++n) {
        const int column = sheet.site[n] % (p.sheet.columns + 1);
        if (distance_of(spread, p.sheet, column) > kLit || sheet.held[n] != 0) continue;
        sheet.temperature[n] = p.burning.ignition + kHotter;
        // heat that no fire gave must still stand in the ledger
        state.heat.given_fire +=
            heat_capacity(p.paper, sheet.initial_mass[n]) * (sheet.temperature[n] - p.heat.ambient);
    }
    world.restore(std::move(state));
}

double mass_of(const WorldState& state) {
    double sum = 0;
    for (const double m : state.sheets[0].mass)
        sum += m;
    return sum;
}

// What is known after each tick.
class StripRecord {
  public:
    StripRecord(const World& world, Spread spread)
        : middle_(middle_of(world.params().sheet, spread)),
          cell_(world.params().sheet.height / world.params().sheet.columns),
          rows_(static_cast<double>(middle_.size()) / (world.params().sheet.columns + 1)),
          initial_mass_(mass_of(world.state())) {}

    void look(const WorldState& state) {
        const SheetState& sheet = state.sheets[0];
        double burning = 0, lit = 0, part = 0;
        ended_ = true;
        for (const Place& p : middle_) {
            const Phase phase = sheet.phase[p.node];
            burning += phase == Phase::Burning ? 1 : 0;
            if (!in_part(p.distance)) continue;
            ++part;
            lit += phase == Phase::Unburnt ? 0 : 1;
            ended_ = ended_ && phase == Phase::BurntOut;
        }
        if (lit > 0 && lit < part) {
            band_ += burning * cell_ / rows_;
            ++looks_;
        }
        const double gone = state.totals.burnt_mass;
        mass_error_ =
            std::max(mass_error_, std::abs(mass_of(state) + gone - initial_mass_) / initial_mass_);
    }

    [[nodiscard]] bool ended() const { return ended_; }

    void finish(const World& world, StripRun& run) const {
        const SheetState& sheet = world.state().sheets[0];
        std::vector<FrontPoint> front;
        double burnt = 0, passed = 0;
        for (const Place& p : middle_) {
            const bool lit = sheet.phase[p.node] != Phase::Unburnt;
            passed += lit ? 1 : 0;
            if (!lit || !in_part(p.distance)) continue;
            front.push_back({p.distance, sheet.ignition_time[p.node]});
            if (sheet.phase[p.node] != Phase::BurntOut) continue;
            ++burnt;
            run.burn_time += sheet.burnout_time[p.node] - sheet.ignition_time[p.node];
            run.residual_mass += sheet.mass[p.node] / sheet.initial_mass[p.node];
        }
        run.front = fit_front(front);
        run.spread_rate = run.front.speed * world.params().paper.grammage;
        run.reached = passed / static_cast<double>(middle_.size());
        run.band = looks_ > 0 ? band_ / looks_ : 0;
        run.burn_time /= std::max(burnt, 1.0);
        run.residual_mass /= std::max(burnt, 1.0);
        run.mass_error = mass_error_;
    }

  private:
    std::vector<Place> middle_;
    double cell_, rows_, initial_mass_;
    double band_ = 0, looks_ = 0, mass_error_ = 0;
    bool ended_ = false;
};

bool fire_lives(const WorldState& state) {
    const auto& phase = state.sheets[0].phase;
    return state.fire.size() > 0 ||
           std::find(phase.begin(), phase.end(), Phase::Burning) != phase.end();
}

// Shrinkage of the structural springs between sites of the part that have burnt out.
double shrink_of(const World& world, const WorldState& before, Spread spread) {
    const SheetParams& p = world.params().sheet;
    const SheetState& sheet = world.state().sheets[0];
    const std::vector<double>& initial = before.sheets[0].rest_length;
    const auto sites = static_cast<std::size_t>((p.rows + 1) * (p.columns + 1));
    double sum = 0, count = 0;
    for (const Place& place : middle_of(p, spread)) {
        const std::size_t next = place.node + 1;  // along the row
        if (!in_part(place.distance) || next >= sites || !(initial[place.node] > 0)) continue;
        if (sheet.phase[place.node] != Phase::BurntOut || sheet.phase[next] != Phase::BurntOut)
            continue;
        sum += 1.0 - sheet.rest_length[place.node] / initial[place.node];
        ++count;
    }
    return sum / std::max(count, 1.0);
}

}  // namespace

FrontFit fit_front(std::span<const FrontPoint> points) {
    const auto n = static_cast<double>(points.size());
    if (points.empty()) return {};
    double t = 0, x = 0;
    for (const FrontPoint& p : points)
        t += p.time / n, x += p.distance / n;
    double tt = 0, tx = 0, xx = 0;
    for (const FrontPoint& p : points) {
        tt += (p.time - t) * (p.time - t);
        tx += (p.time - t) * (p.distance - x);
        xx += (p.distance - x) * (p.distance - x);
    }
    if (!(tt > 0) || !(xx > 0)) return {};
    return {tx / tt, tx * tx / (tt * xx)};
}

StripRun run_strip(const Params& grade, Spread spread, double cell) {
    const double start = thread_seconds();
    World world = make_world(strip_params(grade, spread, cell));
    const WorldState before = world.snapshot();
    light_edge(world, spread);
    StripRecord record(world, spread);
    StripRun run;
    const double patience = 2 * kLength * grade.paper.grammage / kSlowest;
    do {
        const StepReport report = world.step();
        if (!report.ok()) run.failure = divergence_text(report);
        record.look(world.state());
    } while (run.failure.empty() && !record.ended() && fire_lives(world.state()) &&
             world.state().time < patience);
    record.finish(world, run);
    run.shrink = shrink_of(world, before, spread);
    run.duration = world.state().time;
    const EnergyLedger& e = world.state().energy;
    run.energy_error = e.largest > 0 ? std::max(0.0, e.unaccounted) / e.largest : 0;
    const HeatLedger& h = world.state().heat;
    const double given = h.given_fire + h.given_burning;
    run.heat_error = std::abs(h.stored + h.lost_air + h.lost_held - given) / given;
    run.seconds = thread_seconds() - start;
    return run;
}

}  // namespace ember
