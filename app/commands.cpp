#include "app/commands.h"

#include <CLI/CLI.hpp>

#include "app/command_page.h"
#include "app/version.h"

namespace ember {
namespace {

constexpr Example kProgram[] = {
    {"emberleaf paper/corner", "the window"},
    {"emberleaf render paper/corner -o out/frame_####.png", "pictures"},
    {"emberleaf render paper/corner -o burn.mp4 --turntable 90", "a film"},
    {"emberleaf COMMAND --help", "the options of a command"},
};
constexpr Example kRender[] = {
    {"emberleaf render paper/corner -o f_####.png -o burn.mp4", "pictures and a film"},
    {"emberleaf render paper/corner -o t.mov --transparent --fps 24", "with alpha, for an editor"},
    {"emberleaf render paper/corner -o turn_####.png --turntable 360 --at 4", "around a still"},
    {"emberleaf render paper/corner -o f_####.png --skip-existing", "goes on after an end"},
};
constexpr Example kSheet[] = {
    {"emberleaf sheet paper/corner -o fire.png --grid 8x8 --transparent", "fire.png and fire.json"},
};
constexpr Example kSimulate[] = {
    {"emberleaf simulate paper/corner --seconds 5 --stats s.json", "statistics of every tick"},
    {"emberleaf simulate paper/corner --state s_##.ply --at 1,2,4", "three states"},
};
constexpr Example kExport[] = {
    {"emberleaf export paper/corner -o burn.usda --fps 24", "one file with time samples"},
    {"emberleaf export paper/corner -o burn_####.ply", "a sequence"},
};
constexpr Example kSweep[] = {
    {"emberleaf sweep paper/corner --vary paper.grammage=60,80,120 -o sheet.png", "three papers"},
    {"emberleaf sweep paper/corner --vary springs.damping=0.1..10:log:5 -o s.png --array 2/8",
     "a share of it"},
};
constexpr Example kShow[] = {
    {"emberleaf show out/frame_0042.png", "how a picture was made"},
    {"emberleaf show out/frame_0042.png --preset > mine.toml", "its preset"},
};
constexpr Example kDiff[] = {
    {"emberleaf diff golden new --junit diff.xml --html diff.html", "two folders, in CI"},
    {"emberleaf diff a.png b.png --fail 4 --fail-percent 1", "as idiff would"},
};
constexpr Example kCheck[] = {{"emberleaf check mine.toml", "every problem, where it stands"}};
constexpr Example kParams[] = {{"emberleaf params | less", "keys, defaults, ranges, meaning"}};
constexpr Example kBench[] = {{"emberleaf bench stages paper/corner", "time per stage"}};
constexpr Example kMan[] = {{"emberleaf man | man -l -", "reads it"}};
constexpr Example kCompletion[] = {
    {"source <(emberleaf completion bash)", "in this shell"},
};

constexpr CommandRow kRows[] = {
    {"", "simulates and draws burning paper", add_window_command, kProgram},
    {"render", "draw pictures or a film, without a window", add_render_command, kRender},
    {"sheet", "draw a shot into one picture, for games", add_sheet_command, kSheet},
    {"simulate", "simulate without drawing", add_simulate_command, kSimulate},
    {"export", "write moving geometry for other programs", add_export_command, kExport},
    {"sweep", "burn many variants, into a contact sheet and a table", add_sweep_command, kSweep},
    {"show", "say how a picture was made", add_show_command, kShow},
    {"diff", "compare pictures; ends with 3 when they differ", add_diff_command, kDiff},
    {"check", "say everything that is wrong with presets", add_check_command, kCheck},
    {"presets", "list the built-in presets", add_presets_command, {}},
    {"params", "list the parameters", add_params_command, kParams},
    {"bench", "measure accuracy, speed and robustness", add_bench_command, kBench},
    {"man", "write the manual page", add_man_command, kMan},
    {"completion", "write the completion for a shell", add_completion_command, kCompletion},
};

}  // namespace

std::span<const CommandRow> command_rows() {
    return kRows;
}

const CommandRow* find_command(std::string_view name) {
    for (const CommandRow& row : kRows) {
        if (row.name == name) return &row;
    }
    return nullptr;
}

void build_command_line(CLI::App& app, Task& task) {
    app.set_version_flag("--version", std::string("emberleaf ") + kVersion);
    app.require_subcommand(0, 1);
    app.formatter_fn([](const CLI::App* command, const std::string&, CLI::AppFormatMode) {
        return help_text(page_of(*command));
    });
    for (const CommandRow& row : kRows) {
        CLI::App* command = &app;
        if (!row.name.empty())
            command = app.add_subcommand(std::string(row.name), std::string(row.summary));
        row.add(*command, task);
    }
}

}  // namespace ember
