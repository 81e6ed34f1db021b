#include "app/bench/stress_run.h"

#include <optional>
#include <stdexcept>

#include "app/bench/state_oracle.h"
#include "app/run_options.h"
#include "sim/random.h"

namespace ember {
namespace {

// Counted work after which a case has shown enough.
constexpr std::int64_t kMostSprings = 60'000'000, kMostParticles = 3'000'000,
                       kMostPairs = 30'000'000;

bool has_cost_enough(const StepCounters& c, StepCounters& sum) {
    sum.spring_evaluations += c.spring_evaluations;
    sum.particles_moved += c.particles_moved + c.particles_born;
    sum.coupling_pairs += c.coupling_pairs;
    return sum.spring_evaluations > kMostSprings || sum.particles_moved > kMostParticles ||
           sum.coupling_pairs > kMostPairs;
}

void fail(StressOutcome& outcome, const std::string& why) {
    outcome.end = StressEnd::Failed;
    outcome.detail = why;
}

// A run that stops must say why and leave the world as it was.
void judge_stop(const StepReport& report, const World& world, std::uint64_t before,
                StressOutcome& outcome) {
    outcome.end = StressEnd::Stopped;
    outcome.detail = divergence_text(report);
    if (report.reason.empty()) fail(outcome, "stopped without a reason");
    if (world.hash() != before) fail(outcome, "stopped, but the world has changed");
    if (report.time != world.state().time) fail(outcome, "stopped, but at another time");
}

// Exceptions are wrong in a tick that succeeds at once; that they changed nothing is luck.
void judge_traps(const StepReport& report, FloatTraps* watch, StressOutcome& outcome) {
    if (watch == nullptr) return;
    const std::vector<FloatTrap> traps = watch->take();
    if (report.retries > 0 || !report.ok()) {
        outcome.excused_traps += static_cast<int>(traps.size());
    } else {
        outcome.traps.insert(outcome.traps.end(), traps.begin(), traps.end());
    }
}

void run_ticks(const StressCase& stress, World& world, FloatTraps* watch, StressOutcome& outcome) {
    StateOracle oracle(world.params(), world.state());
    StepCounters sum;
    for (int tick = 0; tick < stress.ticks; ++tick) {
        if (stress.during) stress.during(world, tick);
        const std::uint64_t before = world.hash();
        const StepReport report = world.step(watch);
        outcome.retries += report.retries;
        judge_traps(report, watch, outcome);
        if (!report.ok()) return judge_stop(report, world, before, outcome);
        ++outcome.ticks;
        const std::string problem = oracle.problem(world.params(), world.state());
        if (!problem.empty()) return fail(outcome, problem);
        if (has_cost_enough(report.counters, sum)) return;
    }
}

// A hash of each field, with its name.
struct FieldHashes {
    std::vector<std::pair<std::string, std::uint64_t>> fields;

    template <class T>
    void operator()(const char* name, const std::vector<T>& array) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(array.data());
        std::uint64_t hash = array.size();
        for (std::size_t i = 0; i < array.size() * sizeof(T); ++i)
            hash = mix(hash ^ bytes[i]);
        fields.emplace_back(name, hash);
    }
    template <class T>
    void operator()(const char* name, const T& value) {
        (*this)(name, std::vector<T>{value});
    }
};

// Names of the fields in which two states differ.
std::string different_fields(const WorldState& a, const WorldState& b) {
    FieldHashes first, second;
    for_each_field(a, first);
    for_each_field(b, second);
    std::string names;
    for (std::size_t i = 0; i < first.fields.size(); ++i) {
        if (first.fields[i] != second.fields[i]) names += ' ' + first.fields[i].first;
    }
    return names;
}

// The first tick that is rolled back must end in the same bits as a tick that asked for the finer
// sub-steps from the start.
void compare_rollback(const StressCase& stress, World& world, StressOutcome& outcome) {
    World clean = make_world(world.params());
    for (; outcome.ticks < stress.ticks; ++outcome.ticks) {
        WorldState before = world.snapshot();
        const StepReport report = world.step();
        if (!report.ok()) {
            outcome.end = StressEnd::Stopped;
            outcome.detail = divergence_text(report);
            return;
        }
        if (report.retries == 0) continue;
        outcome.retries = report.retries;
        before.refinement += report.retries;
        clean.restore(std::move(before));
        if (!clean.step().ok()) return fail(outcome, "a tick succeeds only when it is rolled back");
        // the two differ in how they came to the finer sub-steps
        WorldState bits = clean.snapshot();
        bits.refinement = world.state().refinement;
        bits.totals.retries = world.state().totals.retries;
        if (hash_of(bits) != world.hash()) {
            fail(outcome,
                 "rolled back differs from clean in" + different_fields(bits, world.state()));
        }
        return;
    }
}

}  // namespace

std::string_view stress_end_name(StressEnd end) {
    constexpr std::string_view kNames[] = {"ran", "stopped", "refused", "FAILED"};
    return kNames[static_cast<std::size_t>(end)];
}

StressOutcome run_stress(const StressCase& stress, bool traps) {
    StressOutcome outcome;
    std::optional<World> world;
    const Params params = stress_params(stress);
    try {
        world.emplace(make_world(params));
    } catch (const std::invalid_argument& e) {
        outcome.end = StressEnd::Refused;
        outcome.detail = e.what();
        return outcome;
    }
    if (stress.prepare) stress.prepare(*world);
    if (stress.demand == StressDemand::RollsBack) {
        compare_rollback(stress, *world, outcome);
        return outcome;
    }
    if (traps && stress.demand == StressDemand::RunsOrStops) {
        FloatTraps watch;
        run_ticks(stress, *world, &watch, outcome);
    } else {
        run_ticks(stress, *world, nullptr, outcome);
    }
    if (!outcome.traps.empty() && outcome.end != StressEnd::Failed) {
        fail(outcome, "floating-point exception in a tick that was not rolled back");
    }
    if (stress.demand == StressDemand::Stops && outcome.end != StressEnd::Stopped) {
        fail(outcome, "the fault was not noticed: " + outcome.detail);
    }
    return outcome;
}

}  // namespace ember
