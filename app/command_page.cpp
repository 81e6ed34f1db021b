#include "app/command_page.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/commands.h"

namespace ember {
namespace {

constexpr std::size_t kWidth = 100, kIndent = 2, kColumn = 32;  // [characters]

// CLI11 adds what a value is checked for, after a colon.
std::string bare(const std::string& type) {
    return type.substr(0, type.find(':'));
}

OptionPage page_of(const CLI::Option& option) {
    OptionPage page;
    if (!option.get_snames().empty()) page.short_name = '-' + option.get_snames().front();
    if (!option.get_lnames().empty()) page.long_name = "--" + option.get_lnames().front();
    const bool flag = option.get_items_expected_max() == 0;
    if (!flag) page.value = bare(option.get_type_name());
    if (page.is_argument()) page.value = option.get_name();
    page.help = option.get_description();
    page.group = option.get_group();
    page.initial = option.get_default_str();
    page.required = option.get_required();
    page.several = option.get_items_expected_max() > 1;
    return page;
}

std::string usage(const CommandPage& page) {
    std::string text = page.name;
    for (const OptionPage& option : page.options) {
        if (!option.is_argument()) continue;
        const std::string word = option.value + (option.several ? "..." : "");
        text += option.required ? ' ' + word : " [" + word + ']';
    }
    for (const OptionPage& option : page.options) {
        if (option.required && !option.is_argument())
            text += ' ' + option.short_name + ' ' + option.value;
    }
    if (page.name == "emberleaf") return text + "\n       emberleaf COMMAND ...";
    return text + (page.commands.empty() ? " [OPTIONS]" : " COMMAND [OPTIONS]");
}

std::string label(const OptionPage& option) {
    if (option.is_argument()) return option.value;
    std::string text = option.short_name.empty() ? "    " : option.short_name + ", ";
    if (option.long_name.empty()) text = option.short_name;
    return text + option.long_name + (option.value.empty() ? "" : ' ' + option.value);
}

// `left` and then `right` from a column on, both indented, with lines broken between words.
void put_row(std::ostringstream& out, const std::string& left, const std::string& right,
             std::size_t column = kColumn) {
    std::string line = std::string(kIndent, ' ') + left;
    if (line.size() + 1 > column && !right.empty()) {
        out << line << '\n';
        line.clear();
    }
    line.resize(std::max(line.size(), right.empty() ? 0 : column), ' ');
    std::istringstream words(right);
    for (std::string word; words >> word;) {
        if (line.size() + word.size() > kWidth) {
            line.pop_back();
            out << line << '\n';
            line.assign(column, ' ');
        }
        line += word + ' ';
    }
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    out << line << '\n';
}

}  // namespace

std::vector<std::string> OptionPage::choices() const {
    std::vector<std::string> words;
    std::istringstream in(value);
    for (std::string word; std::getline(in, word, '|');) {
        const bool lower = std::all_of(word.begin(), word.end(), [](unsigned char c) {
            return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
        });
        if (lower) words.push_back(word);
    }
    return words;
}

CommandPage page_of(const CLI::App& command) {
    CommandPage page;
    page.word = command.get_name();
    for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
        page.name = app->get_name() + (page.name.empty() ? "" : ' ' + page.name);
    page.summary = command.get_description();
    for (const CLI::Option* option : command.get_options())
        page.options.push_back(page_of(*option));
    std::stable_partition(page.options.begin(), page.options.end(), [](const OptionPage& option) {
        return option.long_name != "--help" && option.long_name != "--version";
    });
    for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; }))
        page.commands.push_back(page_of(*inner));
    const bool inner =
        command.get_parent() != nullptr && command.get_parent()->get_parent() != nullptr;
    const CommandRow* row = find_command(command.get_parent() == nullptr ? "" : page.word);
    if (row != nullptr && !inner) {
        for (const Example& example : row->examples)
            page.examples.emplace_back(example.line, example.what);
    }
    return page;
}

std::string help_text(const CommandPage& page) {
    std::ostringstream out;
    out << page.name << ": " << page.summary << "\nusage: " << usage(page) << '\n';
    if (!page.commands.empty()) out << "\nCommands:\n";
    for (const CommandPage& command : page.commands)
        put_row(out, command.word, command.summary, 18);
    std::vector<std::string> groups;
    for (const OptionPage& option : page.options) {
        if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
            groups.push_back(option.group);
    }
    for (const std::string& group : groups) {
        out << '\n' << group << ":\n";
        for (const OptionPage& option : page.options) {
            if (option.group != group) continue;
            const bool tell = !option.initial.empty() && !option.value.empty();
            put_row(out, label(option), option.help + (tell ? " [" + option.initial + ']' : ""));
        }
    }
    if (!page.examples.empty()) out << "\nExamples:\n";
    std::size_t column = 0;
    for (const auto& [line, what] : page.examples)
        column = std::max(column, line.size() + kIndent + 2);
    for (const auto& [line, what] : page.examples)
        put_row(out, line, what, column);
    return out.str();
}

}  // namespace ember
