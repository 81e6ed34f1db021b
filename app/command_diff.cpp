// emberleaf diff: whether pictures are what they were.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/picture_pairs.h"
#include "app/preset_io/atomic_file.h"

namespace ember {
namespace {

struct DiffOptions {
    std::string expected, drawn;
    DifferenceLimits limits;
    bool close = false, json = false, quiet = false;
    std::string output, html, junit;
    int gain = 16;
};

void print(const PairResult& result) {
    std::printf("%s: %s%s\n", result.pair.name.c_str(),
                result.same ? "" : "DIFFERS: ", result.text.c_str());
    if (result.same || result.made_otherwise.empty()) return;
    std::string words;
    for (const std::string& word : result.made_otherwise)
        words += (words.empty() ? "" : ", ") + word;
    std::printf("    made otherwise: %s (emberleaf show FILE)\n", words.c_str());
}

int diff(const DiffOptions& options) {
    const DifferenceLimits limits = options.close ? kCloseLimits : options.limits;
    const std::vector<PicturePair> pairs = find_pairs(options.expected, options.drawn);
    if (!options.output.empty() && std::filesystem::is_directory(options.expected))
        throw InputError("--output: error: for two files; --html shows those of folders");
    std::vector<PairResult> results;
    std::size_t different = 0;
    for (const PicturePair& pair : pairs) {
        results.push_back(compare_pair(pair, limits));
        different += results.back().same ? 0u : 1u;
        if (!options.json && !(options.quiet && results.back().same)) print(results.back());
    }
    if (!options.output.empty() && results.front().difference.comparable) {
        write_png(options.output, difference_image(read_image(options.expected),
                                                   read_image(options.drawn), options.gain));
    }
    if (!options.html.empty()) write_file(options.html, results_html(results));
    if (!options.junit.empty()) write_file(options.junit, results_junit(results));
    if (options.json)
        std::fputs(results_json(results, limits).c_str(), stdout);
    else if (!options.quiet && pairs.size() > 1)
        std::printf("%zu of %zu pictures differ\n", different, pairs.size());
    return different == 0 ? kOk : kComparisonFailed;
}

void add_limits(CLI::App& command, DiffOptions& options) {
    const char* group = "Limits";
    auto* close = command.add_flag("--close", options.close,
                                   "those for another rasteriser: 2 levels in 0.01 %, block 0.2");
    command
        .add_option("--fail", options.limits.fail,
                    "a pixel counts when a channel differs by more levels of 255")
        ->check(CLI::Range(0, 255))
        ->capture_default_str()
        ->type_name("LEVELS")
        ->group(group)
        ->excludes(close);
    command.add_option("--fail-percent", options.limits.fail_percent, "of pixels that may count")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str()
        ->type_name("PERCENT")
        ->group(group)
        ->excludes(close);
    command
        .add_option("--hard-fail", options.limits.hard_fail, "no pixel may differ by more levels")
        ->check(CLI::Range(0, 255))
        ->capture_default_str()
        ->type_name("LEVELS")
        ->group(group)
        ->excludes(close);
    command
        .add_option("--block", options.limits.block,
                    "largest mean difference of a block of 16x16 pixels; default: any")
        ->check(CLI::Range(0.0, 255.0))
        ->type_name("LEVELS")
        ->group(group)
        ->excludes(close);
    close->group(group);
}

}  // namespace

void add_diff_command(CLI::App& command, Task& task) {
    const auto options = std::make_shared<DiffOptions>();
    command.add_option("REF", options->expected, "a PNG file as it should be, or a folder of them")
        ->required();
    command.add_option("NEW", options->drawn, "a PNG file or a folder, to compare with it")
        ->required();
    add_limits(command, *options);
    const char* group = "Output";
    command.add_option("-o,--output", options->output, "a PNG of the differences of two files")
        ->type_name("FILE")
        ->group(group);
    command.add_option("--gain", options->gain, "of that picture")
        ->check(CLI::Range(1, 255))
        ->capture_default_str()
        ->type_name("N")
        ->group(group);
    command.add_option("--html", options->html, "what differs, side by side in one file")
        ->type_name("FILE")
        ->group(group);
    command.add_option("--junit", options->junit, "a test case per picture, for CI")
        ->type_name("FILE")
        ->group(group);
    auto* json =
        command.add_flag("--json", options->json, "figures on standard output")->group(group);
    command.add_flag("-q,--quiet", options->quiet, "only what differs")
        ->group(group)
        ->excludes(json);
    command.callback([options, &task] { task = [options] { return diff(*options); }; });
}

}  // namespace ember
