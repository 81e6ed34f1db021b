#include "app/bench/validate_table.h"

#include <cmath>

#include "app/bench/bench_run.h"

namespace ember {
namespace {

constexpr double kResidueMargin = 0.01;                    // [1] of the initial mass
constexpr double kMassMargin = 1e-9, kHeatMargin = 1e-10;  // [1]
constexpr double kEnergyMargin = 1e-3;                     // [1] of the largest term
constexpr double kLeastShrink = 0.05, kMostShrink = 0.25;  // [1] of charred cellulose, in its plane
constexpr double kStraight = 0.98;                         // [1] R^2 of a steady front

CheckLine within(const GradeRuns& grade, const std::string& what, double value, double least,
                 double most, double unit) {
    const bool inside = value >= least && value <= most;
    return {grade.name, what, short_text(value / unit),
            short_text(least / unit) + " to " + short_text(most / unit),
            inside ? Verdict::Pass : Verdict::Fail};
}

CheckLine at_most(const GradeRuns& grade, const std::string& what, double value, double most) {
    return {grade.name, what, short_text(value, 2), "at most " + short_text(most),
            value <= most ? Verdict::Pass : Verdict::Fail};
}

std::string speed_text(const StripRun& run) {
    return run.front.speed > 0 ? short_text(1e3 * run.front.speed) : "goes out";
}

void check_horizontal(const GradeRuns& grade, const StripRun& run, std::vector<CheckLine>& lines) {
    const double grammage = grade.params.paper.grammage;
    constexpr double kRounding = 1e-12;
    lines.push_back(within(grade, "speed x grammage [g/(m s)]", run.spread_rate, kLeastSpreadRate,
                           kMostSpreadRate, 1e-3));
    if (grammage < kLeastGrammage - kRounding || grammage > kMostGrammage + kRounding)
        lines.back().verdict = Verdict::Reported;
    lines.push_back(within(grade, "straightness R^2", run.front.r_squared, kStraight, 1, 1));
    const double residue = grade.params.burning.residual_mass;
    lines.push_back(within(grade, "residual mass [%]", run.residual_mass, residue - kResidueMargin,
                           residue + kResidueMargin, 0.01));
    lines.push_back(
        within(grade, "shrinkage of ash [%]", run.shrink, kLeastShrink, kMostShrink, 0.01));
}

void check_order(const GradeRuns& grade, const StripRun& flat, const StripRun& up,
                 const StripRun& down, std::vector<CheckLine>& lines) {
    const bool ordered = up.front.speed > flat.front.speed && flat.front.speed > down.front.speed;
    lines.push_back({grade.name, "up, horizontal, down [mm/s]",
                     speed_text(up) + ", " + speed_text(flat) + ", " + speed_text(down), "falling",
                     ordered ? Verdict::Pass : Verdict::Fail});
}

void check_ledgers(const GradeRuns& grade, std::vector<CheckLine>& lines) {
    double mass = 0, heat = 0, energy = 0;
    for (const auto& run : grade.runs) {
        if (!run) continue;
        if (!run->failure.empty())
            lines.push_back({grade.name, "run", run->failure, "to its end", Verdict::Fail});
        mass = std::max(mass, run->mass_error);
        heat = std::max(heat, run->heat_error);
        energy = std::max(energy, run->energy_error);
    }
    lines.push_back(at_most(grade, "mass ledger", mass, kMassMargin));
    lines.push_back(at_most(grade, "heat ledger", heat, kHeatMargin));
    lines.push_back(at_most(grade, "energy ledger", energy, kEnergyMargin));
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

std::vector<std::string> cells_of(const GradeRuns& grade, std::size_t spread) {
    const StripRun& r = *grade.runs[spread];
    return {grade.name,
            short_text(1e3 * grade.params.paper.grammage),
            std::string(kSpreadNames[spread]),
            short_text(1e3 * r.front.speed),
            short_text(1e3 * r.spread_rate),
            short_text(r.front.r_squared, 4),
            short_text(100 * r.reached),
            short_text(1e3 * r.band),
            short_text(r.burn_time),
            short_text(100 * r.residual_mass),
            short_text(100 * r.shrink)};
}

const std::vector<std::string> kColumns = {"preset",
                                           "grammage [g/m^2]",
                                           "front goes",
                                           "speed [mm/s]",
                                           "speed x grammage [g/(m s)]",
                                           "R^2",
                                           "reached [%]",
                                           "burning band [mm]",
                                           "burning for [s]",
                                           "residual mass [%]",
                                           "shrinkage [%]"};

}  // namespace

std::vector<CheckLine> check_grade(const GradeRuns& grade) {
    std::vector<CheckLine> lines;
    const auto& flat = grade.run(Spread::Horizontal);
    const auto& up = grade.run(Spread::Up);
    const auto& down = grade.run(Spread::Down);
    if (flat) check_horizontal(grade, *flat, lines);
    if (flat && up && down) check_order(grade, *flat, *up, *down, lines);
    check_ledgers(grade, lines);
    return lines;
}

std::string verdict_text(Verdict verdict) {
    return verdict == Verdict::Pass ? "pass" : verdict == Verdict::Fail ? "FAIL" : "reported";
}

std::string runs_csv(const std::vector<GradeRuns>& grades) {
    CsvTable table(kColumns);
    for (const GradeRuns& grade : grades) {
        for (std::size_t s = 0; s < grade.runs.size(); ++s) {
            if (grade.runs[s]) table.add(cells_of(grade, s));
        }
    }
    return table.text();
}

std::string validation_page(const std::vector<GradeRuns>& grades, double cell, bool quick) {
    std::string text =
        "# Validation\n\n"
        "Whether paper of the `real/` presets burns as paper does. Written by\n\n"
        "    emberleaf bench validate" +
        std::string(quick ? " --quick" : "") +
        " --doc docs/VALIDATION.md\n\n"
        "A strip of 100 mm x 300 mm, held by its long edges, is lit along a short one. The speed "
        "of the front is the slope of distance over time of ignition, by least squares, between 30 "
        "and 80 % of the length and in the middle half of the width. Cells are " +
        short_text(1e3 * cell) +
        " mm wide. Over thin paper a horizontal front moves at 0.35 to 0.56 g/(m s) divided by the "
        "grammage (P. H. Thomas and M. Law, Fire Research Note 584, 1965); this is documented for "
        "about 60 to 200 g/m^2 and is only reported for other grades.\n\n## Checks\n\n" +
        head_of({"preset", "what", "measured", "allowed", "verdict"});
    for (const GradeRuns& grade : grades) {
        for (const CheckLine& line : check_grade(grade))
            text += row_of(
                {line.grade, line.what, line.measured, line.allowed, verdict_text(line.verdict)});
    }
    text += "\n## Runs\n\n" + head_of(kColumns);
    for (const GradeRuns& grade : grades) {
        for (std::size_t s = 0; s < grade.runs.size(); ++s) {
            if (grade.runs[s]) text += row_of(cells_of(grade, s));
        }
    }
    return text;
}

}  // namespace ember
