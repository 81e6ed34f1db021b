#include "app/bench/accuracy_page.h"

#include <algorithm>
#include <cmath>

namespace ember {
namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "`" : ", `") + name + '`';
    return text;
}

std::string name_of(const WorkSetting& setting) {
    return setting.method + ", " + setting.label;
}

std::string row_of(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells)
        text += ' ' + cell + " |";
    return text + '\n';
}

std::string head_of(const std::vector<std::string>& cells) {
    return row_of(cells) + row_of(std::vector<std::string>(cells.size(), "---"));
}

// How many times slower `point` is than the cheapest run of the sweep at its error.
double waste_of(const WorkProblem& problem, const WorkPoint& point) {
    const auto cheapest = cheapest_like(problem, point);
    // none is as accurate: nothing cheaper would do
    return cheapest ? point.seconds / cheapest->seconds : 1.0;
}

std::string frontier_table(const WorkProblem& problem) {
    std::string text =
        head_of({"method", "setting", "time [ms]", problem.work_title, problem.error_titles[0]});
    for (const WorkPoint& p : efficient_frontier(problem)) {
        const double error = p.errors.front();
        const bool alike = !problem.floor_name.empty() && error <= problem.floor;
        text += row_of({p.setting.method, p.setting.label, short_text(1e3 * p.seconds),
                        std::to_string(p.work),
                        short_text(error) + (alike ? " (within the floor)" : "")});
    }
    return text;
}

std::string default_row(const WorkProblem& problem, const WorkPoint& p) {
    if (p.failed) {
        return row_of({joined(p.presets), name_of(p.setting), "failed", "", "", "**fails**"});
    }
    const auto cheapest = cheapest_like(problem, p);
    const double waste = waste_of(problem, p);
    return row_of({joined(p.presets), name_of(p.setting), short_text(1e3 * p.seconds),
                   short_text(p.errors.front()), cheapest ? name_of(cheapest->setting) : "none",
                   short_text(waste) + (waste > kMostWaste ? " **too slow**" : "")});
}

std::string defaults_table(const WorkProblem& problem) {
    if (problem.defaults.empty()) return "No shipped preset is of this kind.\n";
    std::string text = head_of({"shipped presets", "their default", "time [ms]", "error",
                                "cheapest at this error", "times slower"});
    for (const WorkPoint& point : problem.defaults)
        text += default_row(problem, point);
    return text;
}

// The best of each method at the error of `point`, in words.
std::string reasons(const WorkProblem& problem, const WorkPoint& point) {
    const double error = std::max(point.errors.front(), problem.floor);
    std::vector<WorkPoint> best;
    std::vector<std::string> missing;
    for (const WorkPoint& p : problem.points) {
        if (p.setting.group != point.setting.group) continue;
        const bool known = std::any_of(best.begin(), best.end(), [&](const WorkPoint& b) {
            return b.setting.method == p.setting.method;
        });
        if (!known) best.push_back({.setting = {p.setting.method, "", {}}, .failed = true});
        WorkPoint& b = *std::find_if(best.begin(), best.end(), [&](const WorkPoint& q) {
            return q.setting.method == p.setting.method;
        });
        const bool good = !p.failed && p.errors.front() <= error;
        if (good && (b.failed || p.seconds < b.seconds)) b = p;
    }
    std::sort(best.begin(), best.end(),
              [](const WorkPoint& a, const WorkPoint& b) { return a.seconds < b.seconds; });
    std::string text;
    for (const WorkPoint& b : best) {
        if (b.failed) {
            missing.push_back(b.setting.method);
        } else {
            text += (text.empty() ? "" : ", ") + b.setting.method + ' ' +
                    short_text(1e3 * b.seconds) + " ms (" + b.setting.label + ')';
        }
    }
    text = "Cheapest run of each method with an error of at most " + short_text(error) + ": " +
           (text.empty() ? "none" : text) + '.';
    if (!missing.empty()) text += " Not accurate enough in the sweep: " + joined(missing) + '.';
    return text;
}

std::string section_of(const WorkProblem& problem) {
    std::string text = "## " + problem.title + "\n\n" + problem.subtitle + ". " +
                       problem.reference + "\n\n![" + problem.title + "](accuracy_" + problem.name +
                       ".svg)\n\nRuns that no other beats in both time and error:\n\n" +
                       frontier_table(problem) + '\n' + defaults_table(problem);
    for (const WorkPoint& point : problem.defaults) {
        if (point.failed) continue;
        text += "\nFor " + joined(point.presets) + ": " + reasons(problem, point) + '\n';
    }
    for (const std::string& warning : wasteful_defaults(problem))
        text += "\n**Warning:** " + warning + '\n';
    return text;
}

}  // namespace

std::vector<std::string> wasteful_defaults(const WorkProblem& problem) {
    std::vector<std::string> warnings;
    for (const WorkPoint& point : problem.defaults) {
        const std::string who = joined(point.presets) + " (" + name_of(point.setting) + ')';
        if (point.failed) {
            warnings.push_back(who + " fails on " + problem.name + '.');
        } else if (waste_of(problem, point) > kMostWaste) {
            warnings.push_back(who + " is " + short_text(waste_of(problem, point)) +
                               " times slower on " + problem.name + " than " +
                               name_of(cheapest_like(problem, point)->setting) +
                               ", which is as accurate.");
        }
    }
    return warnings;
}

std::string accuracy_page(const std::vector<WorkProblem>& problems, bool quick) {
    std::string text =
        "# Accuracy\n\n"
        "How accurate each integrator and heat solver is for the time that it takes. Written by\n\n"
        "    emberleaf bench work-precision" +
        std::string(quick ? " --quick" : "") +
        " --doc docs/ACCURACY.md\n\n"
        "on " +
        machine_text() + ". Times are processor time of one thread. A shipped default may take " +
        short_text(kMostWaste) +
        " times as long as the cheapest run with its error; the tables name those that take "
        "longer.\n";
    for (const WorkProblem& problem : problems)
        text += '\n' + section_of(problem);
    return text;
}

}  // namespace ember
