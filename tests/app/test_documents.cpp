// Help, manual page and completions, all from the parser's own table.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "app/command_page.h"
#include "app/commands.h"
#include "child.h"
#include "temporary_folder.h"
#include "tool.h"

namespace ember {
namespace {

struct Program {
    Task task;
    CLI::App app{"test", "emberleaf"};
    CommandPage page;
    Program() {
        build_command_line(app, task);
        page = page_of(app);
    }
};

void visit(const CommandPage& page, const std::function<void(const CommandPage&)>& action) {
    action(page);
    for (const CommandPage& inner : page.commands)
        visit(inner, action);
}

TEST(Help, FitsAScreenAndShowsExamples) {
    const Program program;
    visit(program.page, [](const CommandPage& page) {
        SCOPED_TRACE(page.name);
        std::istringstream text(help_text(page));
        int lines = 0;
        for (std::string line; std::getline(text, line); ++lines)
            EXPECT_LE(line.size(), 100u) << line;
        EXPECT_LE(lines, 60);
        for (const OptionPage& option : page.options)
            EXPECT_FALSE(option.help.empty()) << option.long_name << option.value;
    });
    for (const CommandRow& row : command_rows()) {
        if (row.name == "presets") continue;
        ASSERT_FALSE(row.examples.empty()) << row.name;
    }
    EXPECT_NE(run_emberleaf({"render", "--help"}).out.find("Examples:\n  emberleaf render"),
              std::string::npos);
}

TEST(Help, EveryExampleIsACommandLineThatIsAccepted) {
    for (const CommandRow& row : command_rows()) {
        for (const Example& example : row.examples) {
            std::string line(example.line);
            if (line.find("emberleaf ") != 0 || line.find("COMMAND") != std::string::npos) continue;
            line = line.substr(10, line.find_first_of("|>") - 10);
            Program program;
            EXPECT_NO_THROW(program.app.parse(line)) << line;
            EXPECT_TRUE(program.task) << line;
        }
    }
}

TEST(Manual, HasEveryCommandAndOptionAndNoErrors) {
    const TemporaryFolder folder;
    const std::string page = run_emberleaf({"man"}).out;
    folder.write("emberleaf.1", page);
    const ToolResult errors =
        run_tool("mandoc -T lint -W error '" + (folder / "emberleaf.1").string() + '\'');
    EXPECT_EQ(errors.status, 0) << errors.out;
    const std::string text =
        run_tool("mandoc -T ascii '" + (folder / "emberleaf.1").string() + "' | col -b").out;
    const Program program;
    visit(program.page, [&](const CommandPage& command) {
        EXPECT_NE(text.find(command.name), std::string::npos) << command.name;
        for (const OptionPage& option : command.options)
            EXPECT_NE(text.find(option.long_name), std::string::npos) << option.long_name;
    });
}

// Completes `line` in bash and returns the words.
std::string completed(const TemporaryFolder& folder, const std::string& line) {
    const std::string script = "source " + (folder / "bash").string() +
                               "; PATH=" + folder.path().string() + ":$PATH; COMP_WORDS=(" + line +
                               " ''); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _emberleaf; "
                               "echo \"${COMPREPLY[@]}\"";
    folder.write("run.sh", script);
    return run_tool("bash '" + (folder / "run.sh").string() + '\'').out;
}

TEST(Completion, BashCompletesCommandsOptionsChoicesPresetsAndKeys) {
    const TemporaryFolder folder;
    folder.write("bash", run_emberleaf({"completion", "bash"}).out);
    std::filesystem::create_symlink(EMBERLEAF_BINARY, folder / "emberleaf");
    EXPECT_NE(completed(folder, "emberleaf").find("render"), std::string::npos);
    EXPECT_EQ(completed(folder, "emberleaf render paper/corner --view"),
              "beauty lattice temperature mass state stress stiffness\n");
    EXPECT_NE(completed(folder, "emberleaf render").find("paper/corner"), std::string::npos);
    EXPECT_NE(completed(folder, "emberleaf render x --set").find("paper.grammage="),
              std::string::npos);
    EXPECT_NE(completed(folder, "emberleaf bench").find("work-precision"), std::string::npos);
}

TEST(Completion, ZshAndFishAcceptTheirScripts) {
    const TemporaryFolder folder;
    folder.write("zsh", run_emberleaf({"completion", "zsh"}).out);
    folder.write("fish", run_emberleaf({"completion", "fish"}).out);
    const ToolResult zsh = run_tool("zsh -n '" + (folder / "zsh").string() + '\'');
    EXPECT_EQ(zsh.status, 0) << zsh.out;
    std::filesystem::create_symlink(EMBERLEAF_BINARY, folder / "emberleaf");
    const ToolResult fish =
        run_tool("PATH=" + folder.path().string() + ":$PATH fish --no-config -c 'source " +
                 (folder / "fish").string() + "; complete -C \"emberleaf render --view \"'");
    EXPECT_NE(fish.out.find("temperature"), std::string::npos) << fish.out;
    EXPECT_EQ(run_emberleaf({"completion", "tcsh"}).code, 2);
}

}  // namespace
}  // namespace ember
