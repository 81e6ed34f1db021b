#include "sim/world.h"

#include <algorithm>
#include <utility>

#include "sim/heat.h"
#include "sim/lighter.h"
#include "sim/parallel.h"
#include "sim/param_table.h"
#include "sim/scene_check.h"
#include "sim/sheet_builder.h"
#include "sim/sleep.h"
#include "sim/tick.h"
#include "sim/workspace.h"

namespace ember {
namespace {

constexpr int kMostRetries = 6;
constexpr int kMostRefinement = 12;
constexpr int kRelaxAfter = 8;  // ticks

SheetView view_of(const SheetState& sheet, const SheetPlan& plan, const Lattice& lattice) {
    SheetView view;
    view.row_count = lattice.row_count;
    view.column_count = lattice.column_count;
    view.closed = lattice.closed;
    view.width = plan.width;
    view.height = plan.height;
    view.x = sheet.position.x, view.y = sheet.position.y, view.z = sheet.position.z;
    view.vx = sheet.velocity.x, view.vy = sheet.velocity.y, view.vz = sheet.velocity.z;
    view.temperature = sheet.temperature;
    view.mass = sheet.mass;
    view.initial_mass = sheet.initial_mass;
    view.ignition_time = sheet.ignition_time;
    view.burnout_time = sheet.burnout_time;
    view.phase = sheet.phase;
    view.site = sheet.site;
    view.quads = sheet.quads;
    view.crack_x = sheet.cracks.offset_x, view.crack_z = sheet.cracks.offset_z;
    view.topology_version = sheet.topology_version;
    return view;
}

// Whether the lattice would be built differently.
bool material_differs(const Params& a, const Params& b) {
    return std::ranges::any_of(sim_param_rows(), [&](const ParamInfo& row) {
        const bool material = row.group() == "paper" || row.group() == "springs";
        return material && row.value(&a) != row.value(&b);
    });
}

}  // namespace

World::World(Scene scene, const Params& params, int threads)
    : scene_(std::move(scene)),
      params_(params),
      work_(std::make_unique<Workspace>()),
      pool_(std::make_unique<ThreadPool>(threads)) {
    validate(scene_, caliper(params.paper));
    build_lattices();
    for (std::size_t s = 0; s < scene_.sheets.size(); ++s)
        state_.sheets.push_back(make_sheet(scene_.sheets[s], work_->sheets[s].lattice, params, s));
    refresh_derived(params_, state_, *pool_, *work_);
    record_energy(measure_energy(params_, state_, *pool_, *work_), state_.energy);
    state_.energy.initial =
        state_.energy.kinetic + state_.energy.elastic + state_.energy.gravitational;
    state_.energy.initial_gravitational = state_.energy.gravitational;
}

void World::build_lattices() {
    *work_ = Workspace();
    const auto seed = static_cast<std::uint64_t>(params_.numerics.seed);
    for (std::size_t s = 0; s < scene_.sheets.size(); ++s) {
        SheetWorkspace& w = work_->sheets.emplace_back();
        w.lattice = make_lattice(scene_.sheets[s], params_.paper, params_.springs, seed, s);
        w.gap = scene_.sheets[s].gap;
        w.plate = make_plate(scene_.sheets[s], w.lattice, params_.paper, params_.plate);
    }
}

World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

StepReport World::step(StageObserver* observer) {
    take_scripted();
    const bool checked = params_.numerics.check;
    if (checked) {
        const StageScope scope(observer, Stage::Check);
        // a copy makes room for what it holds and no more, but a fire grows in nearly every tick
        const std::size_t room = state_.fire.id.capacity();
        for_each_array(work_->before.fire, [room](auto& array) { array.reserve(room); });
        work_->before = state_;
    }
    const std::int64_t from = state_.refinement;
    for (int retry = 0;; ++retry) {
        StepReport report = run_tick(
            {params_, state_, *work_, *pool_, observer, tick_duration(), 1 << (from + retry)});
        report.retries = retry;
        if (report.ok()) {
            state_.totals.retries += retry;
            // what was needed once is likely to be needed again for a while
            const bool relax = retry == 0 && from > 0 && state_.tick % kRelaxAfter == 0;
            state_.refinement = from + retry - (relax ? 1 : 0);
            return report;
        }
        if (checked) put_back(work_->before);
        if (!checked || retry == kMostRetries || from + retry == kMostRefinement) return report;
    }
}

void World::take_material(const Params& params) {
    validate(scene_, caliper(params.paper));
    const double heavier = params.paper.grammage / params_.paper.grammage;
    params_ = params;
    build_lattices();
    for (SheetState& sheet : state_.sheets) {
        for (double& mass : sheet.mass)
            mass *= heavier;
        for (double& mass : sheet.initial_mass)
            mass *= heavier;
    }
    HeatLedger& heat = state_.heat;
    const double before = std::exchange(heat.stored, 0.0);
    for (const SheetState& sheet : state_.sheets)
        heat.stored += stored_heat(sheet, params.paper, params.heat.ambient);
    heat.change_edit += heat.stored - before;
}

bool World::apply(const Params& params) {
    if (compare(params, params_) == ParamChange::Rebuild) return false;
    if (material_differs(params, params_)) take_material(params);
    params_ = params;
    for (SheetState& sheet : state_.sheets)
        wake(sheet);
    refresh_derived(params_, state_, *pool_, *work_);
    state_.energy.change_edit +=
        record_energy(measure_energy(params_, state_, *pool_, *work_), state_.energy);
    return true;
}

void World::set_script(const Params& base, std::vector<TimedParams> script) {
    const Params* before = &base;
    for (const TimedParams& entry : script) {
        if (compare(entry.params, *before) == ParamChange::Rebuild)
            throw std::invalid_argument("only live parameters may change in mid-burn");
        before = &entry.params;
    }
    base_ = base;
    script_ = std::move(script);
    const auto done = [&](const TimedParams& entry) { return entry.tick < state_.tick; };
    taken_ = static_cast<std::size_t>(std::ranges::count_if(script_, done));
}

void World::take_scripted() {
    for (; taken_ < script_.size() && script_[taken_].tick <= state_.tick; ++taken_)
        static_cast<void>(apply(script_[taken_].params));  // set_script has looked
}

void World::put_back(WorldState state) {
    state_ = std::move(state);
    for (SheetWorkspace& w : work_->sheets)
        w.network.topology_version = w.plate.topology_version = ~0ull;
    work_->tiles.clear();
    refresh_derived(params_, state_, *pool_, *work_);
}

void World::restore(WorldState state) {
    if (!script_.empty()) {
        const auto done = [&](const TimedParams& entry) { return entry.tick < state.tick; };
        taken_ = static_cast<std::size_t>(std::ranges::count_if(script_, done));
        const Params& before = taken_ == 0 ? base_ : script_[taken_ - 1].params;
        const bool other = material_differs(before, params_);
        params_ = before;
        if (other) build_lattices();
    }
    put_back(std::move(state));
}

std::uint64_t World::hash() const {
    return hash_of(state_);
}

WorldView World::view(const WorldState& state) const {
    WorldView view;
    view.tick = state.tick;
    view.time = state.time;
    view.ambient = params_.heat.ambient;
    view.ignition = params_.burning.ignition;
    view.residual_mass = params_.burning.residual_mass;
    view.burning_time = (1.0 - params_.burning.residual_mass) * params_.paper.grammage /
                        (params_.burning.burn_rate * params_.burning.burn_speed);
    view.fire_temperature = params_.fire.temperature;
    view.caliper = caliper(params_.paper);
    view.ground = params_.world.ground;
    view.lighters = lighters_at(state.time);
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        view.sheets.push_back(view_of(state.sheets[s], scene_.sheets[s], work_->sheets[s].lattice));
    }
    const FireState& fire = state.fire;
    view.particles = {fire.position.x, fire.position.y, fire.position.z,  fire.velocity.x,
                      fire.velocity.y, fire.velocity.z, fire.temperature, fire.birth,
                      fire.death,      fire.id};
    return view;
}

std::vector<LighterView> World::lighters_at(double time) const {
    return view_lighters(work_->lighters, time, tick_duration());
}

std::vector<SpringSegment> World::springs(std::size_t sheet) const {
    std::vector<SpringSegment> segments;
    const SheetWorkspace& w = work_->sheets.at(sheet);
    const Lattice& lattice = w.lattice;
    const SheetState& state = state_.sheets[sheet];
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    std::array<double, kSlotCount> mean{};
    for (std::size_t k = 0; k < mean.size(); ++k) {
        double sum = 0, count = 0;
        for (std::size_t s = k * sites; s < (k + 1) * sites; ++s)
            sum += lattice.stiffness[s], count += lattice.stiffness[s] > 0 ? 1 : 0;
        mean[k] = count > 0 ? sum / count : 1;
    }
    const auto left = [&](Index n) {
        const auto i = static_cast<std::size_t>(n);
        return state.mass[i] / state.initial_mass[i];
    };
    const double caliper = params_.paper.grammage / params_.paper.density;
    for_each_spring(lattice, w.network, [&](Index a, Index b, Index slot, double, double) {
        const auto kind = static_cast<Slot>(slot / lattice.site_count());
        const auto s = static_cast<std::size_t>(slot);
        SpringSegment segment{a, b, spring_kind(kind), lattice.stiffness[s] / mean[s / sites], 0};
        if (segment.kind == SpringKind::Structural) {
            const Vector3 span = state.position.at(static_cast<std::size_t>(b)) -
                                 state.position.at(static_cast<std::size_t>(a));
            const double remains = params_.springs.follows_mass ? std::min(left(a), left(b)) : 1.0;
            const double force =
                lattice.stiffness[s] * remains * (span.norm() - state.rest_length[s]);
            const double wide = kind == Slot::Main ? lattice.row_spacing : lattice.column_spacing;
            segment.stress = force / (wide * caliper);
        }
        segments.push_back(segment);
    });
    return segments;
}

World make_world(const Params& params, int threads) {
    return World(make_scene(params), params, threads);
}

}  // namespace ember
