// emberleaf man and emberleaf completion: what the parser knows, for man(1) and for shells.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/command_page.h"
#include "app/commands.h"
#include "app/exit_code.h"

namespace ember {
namespace {

const CLI::App& program_of(const CLI::App& command) {
    const CLI::App* app = &command;
    while (app->get_parent() != nullptr)
        app = app->get_parent();
    return *app;
}

}  // namespace

void add_man_command(CLI::App& command, Task& task) {
    command.callback([&command, &task] {
        task = [&command] {
            std::fputs(manual_page(page_of(program_of(command))).c_str(), stdout);
            return kOk;
        };
    });
}

void add_completion_command(CLI::App& command, Task& task) {
    const auto shell = std::make_shared<std::string>();
    command.add_option("SHELL", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command.callback([&command, shell, &task] {
        task = [&command, shell] {
            const Shell chosen = *shell == "bash"  ? Shell::Bash
                                 : *shell == "zsh" ? Shell::Zsh
                                                   : Shell::Fish;
            std::fputs(completion_script(page_of(program_of(command)), chosen).c_str(), stdout);
            return kOk;
        };
    });
}

}  // namespace ember
