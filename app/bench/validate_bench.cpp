#include <algorithm>
#include <cstdio>

#include "app/bench/benches.h"
#include "app/bench/validate_table.h"
#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/run_options.h"

namespace ember {
namespace {

constexpr double kCell = 0.00625;  // [m]

std::vector<std::string> real_presets() {
    std::vector<std::string> names = built_in_presets();
    std::erase_if(names, [](const std::string& name) { return !name.starts_with("real/"); });
    return names;
}

void print_lines(const std::vector<CheckLine>& lines) {
    for (const CheckLine& line : lines) {
        std::printf("%-18s %-28s %-22s %-16s %s\n", line.grade.c_str(), line.what.c_str(),
                    line.measured.c_str(), line.allowed.c_str(),
                    verdict_text(line.verdict).c_str());
    }
    std::fflush(stdout);
}

}  // namespace

int bench_validate(const ValidateOptions& options) {
    std::vector<GradeRuns> grades;
    for (const std::string& name : options.presets.empty() ? real_presets() : options.presets)
        grades.push_back({name, bench_params(name, options.sets), {}});
    const std::size_t spreads = options.common.quick ? 1 : kSpreadNames.size();
    run_jobs(grades.size() * spreads, options.common.threads, [&](std::size_t i) {
        GradeRuns& grade = grades[i / spreads];
        const std::size_t spread = i % spreads;
        grade.runs[spread] = run_strip(grade.params, static_cast<Spread>(spread), kCell);
    });
    bool failed = false;
    for (const GradeRuns& grade : grades) {
        const std::vector<CheckLine> lines = check_grade(grade);
        print_lines(lines);
        failed = failed || std::any_of(lines.begin(), lines.end(), [](const CheckLine& line) {
                     return line.verdict == Verdict::Fail;
                 });
    }
    write_file(options.common.out / "validate.csv", runs_csv(grades));
    if (!options.page.empty())
        write_file(options.page, validation_page(grades, kCell, options.common.quick));
    return failed ? kComparisonFailed : kOk;
}

}  // namespace ember
