#include <cstdio>

#include "app/bench/accuracy_page.h"
#include "app/bench/benches.h"
#include "app/bench/burn_problem.h"
#include "app/bench/cosine_problem.h"
#include "app/bench/swing_problem.h"
#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"

namespace ember {
namespace {

void report(const WorkProblem& problem) {
    std::printf("%s\n  %s\n", problem.title.c_str(), problem.reference.c_str());
    for (const WorkPoint& p : efficient_frontier(problem)) {
        std::printf("  %-24s %-28s %10.3f ms  %s\n", p.setting.method.c_str(),
                    p.setting.label.c_str(), 1e3 * p.seconds, short_text(p.errors.front()).c_str());
    }
    for (const std::string& warning : wasteful_defaults(problem))
        std::printf("  warning: %s\n", warning.c_str());
    std::fflush(stdout);
}

}  // namespace

int bench_work_precision(const WorkPrecisionOptions& options) {
    const auto wanted = [&](const char* name) {
        return options.problem.empty() || options.problem == name;
    };
    if (!options.page.empty() && !options.problem.empty()) {
        throw InputError("--doc: error: needs all problems, so not --problem");
    }
    std::vector<WorkProblem> problems;
    const auto add = [&](WorkProblem problem) {
        write_problem(problem, options.common.out);
        report(problem);
        problems.push_back(std::move(problem));
    };
    if (wanted("swing")) add(measure_swing(options.common));
    if (wanted("cosine")) {
        for (WorkProblem& problem : measure_cosine(options.common))
            add(std::move(problem));
    }
    if (wanted("burn")) add(measure_burn(options.common));
    if (options.page.empty()) return kOk;
    const std::filesystem::path page = options.page;
    write_file(page, accuracy_page(problems, options.common.quick));
    for (const WorkProblem& problem : problems) {
        write_file(page.parent_path() / ("accuracy_" + problem.name + ".svg"),
                   problem_chart(problem));
    }
    return kOk;
}

}  // namespace ember
