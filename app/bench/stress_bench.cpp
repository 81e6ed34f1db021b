#include <algorithm>
#include <cstdio>
#include <map>
#include <mutex>
#include <utility>

#include "app/bench/benches.h"
#include "app/bench/chart.h"
#include "app/bench/stress_run.h"
#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/progress.h"

namespace ember {
namespace {

std::vector<StressCase> all_cases(const StressOptions& options) {
    const auto seed = static_cast<std::uint64_t>(options.seed);
    const auto count = static_cast<std::size_t>(options.cases);
    std::vector<StressCase> cases = corner_cases();
    for (auto&& more : {rollback_cases(), fault_cases(std::min<std::size_t>(count, 200), seed),
                        random_cases(count, seed)}) {
        cases.insert(cases.end(), more.begin(), more.end());
    }
    if (!options.only.empty()) {
        std::erase_if(cases, [&](const StressCase& c) { return c.name != options.only; });
        if (cases.empty()) throw InputError("--case: error: no case is named " + options.only);
    }
    return cases;
}

std::string stress_csv(const std::vector<StressCase>& cases,
                       const std::vector<StressOutcome>& outcomes) {
    CsvTable table({"case", "end", "ticks", "retries", "exceptions in", "excused exceptions",
                    "detail", "parameters"});
    for (std::size_t i = 0; i < cases.size(); ++i) {
        std::string traps, sets;
        for (const FloatTrap& trap : outcomes[i].traps)
            traps += std::string(kStageNames[static_cast<std::size_t>(trap.stage)]) + ' ';
        for (const std::string& set : cases[i].sets)
            sets += set + ' ';
        table.add({cases[i].name, std::string(stress_end_name(outcomes[i].end)),
                   std::to_string(outcomes[i].ticks), std::to_string(outcomes[i].retries), traps,
                   std::to_string(outcomes[i].excused_traps), outcomes[i].detail, sets});
    }
    return table.text();
}

// How cases ended, by kind: the name up to the first underscore and digit.
std::string end_chart(const std::vector<StressCase>& cases,
                      const std::vector<StressOutcome>& outcomes) {
    BarChart chart{.title = "How stress cases ended",
                   .subtitle = "corners are made by hand, faults have an impossible number",
                   .x_title = "kind of case",
                   .y_title = "cases",
                   .categories = {"corner", "rollback", "fault", "random"}};
    for (std::size_t end = 0; end < 4; ++end) {
        chart.series.emplace_back(stress_end_name(static_cast<StressEnd>(end)));
        chart.values.emplace_back(chart.categories.size(), 0.0);
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
        std::size_t kind = 0;
        for (std::size_t k = 1; k < chart.categories.size(); ++k) {
            if (cases[i].name.starts_with(chart.categories[k] + '_')) kind = k;
        }
        ++chart.values[static_cast<std::size_t>(outcomes[i].end)][kind];
    }
    return chart_svg(chart);
}

void print_failure(const StressCase& c, const StressOutcome& outcome,
                   const StressOptions& options) {
    std::printf(
        "FAILED %s after %d ticks: %s\n  emberleaf bench stress --cases %d --seed %lld "
        "--case %s\n  %s\n",
        c.name.c_str(), outcome.ticks, outcome.detail.c_str(), options.cases,
        static_cast<long long>(options.seed), c.name.c_str(), reproduction(c).c_str());
}

// Says what fails as soon as it has, since a sweep may take an hour.
void run_all(const std::vector<StressCase>& cases, const StressOptions& options,
             std::vector<StressOutcome>& outcomes) {
    Progress progress("cases", static_cast<long>(cases.size()),
                      Progress::style_of("auto", !options.only.empty()));
    std::mutex one_at_a_time;
    long done = 0;
    run_jobs(cases.size(), options.common.threads, [&](std::size_t i) {
        StressOutcome outcome = run_stress(cases[i], options.traps);
        const std::lock_guard lock(one_at_a_time);
        if (outcome.end == StressEnd::Failed) {
            print_failure(cases[i], outcome, options);
            std::fflush(stdout);
        }
        outcomes[i] = std::move(outcome);
        progress.update(++done);
    });
    progress.finish();
}

// Where floating-point exceptions were, with how many cases and the first of them.
std::size_t print_traps(const std::vector<StressCase>& cases,
                        const std::vector<StressOutcome>& outcomes) {
    struct Place {
        int cases = 0;
        std::string first;
    };
    std::map<std::pair<Stage, std::uintptr_t>, Place> places;
    std::size_t count = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        count += outcomes[i].traps.empty() ? 0u : 1u;
        for (const FloatTrap& trap : outcomes[i].traps) {
            Place& place = places[{trap.stage, trap.offset}];
            if (place.cases++ == 0) place.first = cases[i].name;
        }
    }
    for (const auto& [where, place] : places) {
        std::printf("floating-point exception in stage %s at +0x%zx: %d cases, first %s\n",
                    std::string(kStageNames[static_cast<std::size_t>(where.first)]).c_str(),
                    static_cast<std::size_t>(where.second), place.cases, place.first.c_str());
    }
    return count;
}

}  // namespace

int bench_stress(const StressOptions& options) {
    const std::vector<StressCase> cases = all_cases(options);
    std::vector<StressOutcome> outcomes(cases.size());
    const double start = wall_seconds();
    run_all(cases, options, outcomes);
    int counts[4] = {};
    for (const StressOutcome& outcome : outcomes)
        ++counts[static_cast<std::size_t>(outcome.end)];
    const std::size_t trapped = print_traps(cases, outcomes);
    std::printf(
        "stress: %zu cases in %.1f s: %d ran, %d stopped with a reason, %d refused, "
        "%d failed; %s %zu with floating-point exceptions\n",
        cases.size(), wall_seconds() - start, counts[0], counts[1], counts[2], counts[3],
        FloatTraps::available() && options.traps ? "watched;" : "not watched;", trapped);
    if (!options.only.empty()) {
        std::printf("%s %s after %d ticks: %s\n", options.only.c_str(),
                    std::string(stress_end_name(outcomes[0].end)).c_str(), outcomes[0].ticks,
                    outcomes[0].detail.c_str());
    }
    write_file(options.common.out / "stress.csv", stress_csv(cases, outcomes));
    write_file(options.common.out / "stress.svg", end_chart(cases, outcomes));
    return counts[3] == 0 ? kOk : kRunFailed;
}

}  // namespace ember
