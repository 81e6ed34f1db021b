// What a command and its options are, read from the parser itself: for people and for shells.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ember {

/// One option, or an argument without a name of its own.
struct OptionPage {
    std::string short_name, long_name;  ///< "-o", "--output"; both empty for an argument
    std::string value;                  ///< "FILE", "auto|osmesa|egl"; empty for a flag
    std::string help, initial;          ///< its default, where it is one word
    std::string group;                  ///< heading
    bool required = false, several = false;

    [[nodiscard]] bool is_argument() const { return long_name.empty() && short_name.empty(); }
    /// The values to choose from, when they are lower-case words with '|' between them.
    [[nodiscard]] std::vector<std::string> choices() const;
};

struct CommandPage {
    std::string name;  ///< "emberleaf", "emberleaf render", "emberleaf bench stages"
    std::string word;  ///< the last word of it
    std::string summary;
    std::vector<OptionPage> options;
    std::vector<CommandPage> commands;
    std::vector<std::pair<std::string, std::string>> examples;  ///< command line, what it does
};

[[nodiscard]] CommandPage page_of(const CLI::App& command);

/// What --help prints: not more than 100 columns.
[[nodiscard]] std::string help_text(const CommandPage& page);

/// The manual page of the whole program, section 1.
[[nodiscard]] std::string manual_page(const CommandPage& program);

enum class Shell { Bash, Zsh, Fish };
/// A script that has `shell` complete commands, options, their values, presets and keys.
[[nodiscard]] std::string completion_script(const CommandPage& program, Shell shell);

}  // namespace ember
