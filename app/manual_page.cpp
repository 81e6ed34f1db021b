// The manual page, in the man macros of troff.
#include <sstream>

#include "app/command_page.h"
#include "app/version.h"

namespace ember {
namespace {

// Text as troff takes it literally: no escapes, no request at the start of a line, and dashes that
// can be copied.
std::string literal(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') {
            out += "\\e";
        } else if (c == '-') {
            out += "\\-";
        } else {
            out += c;
        }
    }
    if (!out.empty() && (out[0] == '.' || out[0] == '\'')) out.insert(0, "\\&");
    return out;
}

void put_options(std::ostringstream& out, const CommandPage& page) {
    for (const OptionPage& option : page.options) {
        out << ".TP\n";
        std::string name = option.short_name;
        if (!option.long_name.empty()) name += (name.empty() ? "" : ", ") + option.long_name;
        if (!name.empty()) out << "\\fB" << literal(name) << "\\fR";
        if (!option.value.empty())
            out << (name.empty() ? "" : " ") << "\\fI" << literal(option.value) << "\\fR";
        out << '\n' << literal(option.help);
        if (!option.initial.empty() && !option.value.empty())
            out << "; default: " << literal(option.initial);
        out << ".\n";
    }
}

void put_examples(std::ostringstream& out, const CommandPage& page) {
    for (const auto& [line, what] : page.examples)
        out << ".TP\n\\fB" << literal(line) << "\\fR\n" << literal(what) << '\n';
}

void put_command(std::ostringstream& out, const CommandPage& page) {
    out << ".SS " << literal(page.name) << "\n" << literal(page.summary) << ".\n";
    put_options(out, page);
    put_examples(out, page);
    for (const CommandPage& inner : page.commands)
        put_command(out, inner);
}

}  // namespace

std::string manual_page(const CommandPage& program) {
    std::ostringstream out;
    out << ".TH EMBERLEAF 1 \"\" \"emberleaf " << literal(kVersion)
        << "\" \"User Commands\"\n.SH NAME\nemberleaf \\- " << literal(program.summary)
        << "\n.SH SYNOPSIS\n.B emberleaf\n.RI [ PRESET ]\n.br\n.B emberleaf\n.I COMMAND\n"
           ".RI [ OPTIONS ]\n.SH DESCRIPTION\nWithout a command, the window opens. Everything "
           "else is done by commands; the order of their options does not matter. A preset is a "
           "file, the name of a built\\-in one, or a picture that emberleaf has drawn.\n"
           ".SH OPTIONS\n";
    put_options(out, program);
    out << ".SH COMMANDS\n";
    for (const CommandPage& command : program.commands)
        put_command(out, command);
    out << ".SH EXIT STATUS\n.TP\n.B 0\nDone.\n.TP\n.B 1\nThe run failed: files, graphics, or "
           "numbers.\n.TP\n.B 2\nThe command line or a preset is wrong; nothing was written.\n"
           ".TP\n.B 3\nWhat was compared is not the same.\n.TP\n.BR 130 \", \" 143\nInterrupted, "
           "after the picture in work.\n.SH EXAMPLES\n";
    put_examples(out, program);
    return out.str();
}

}  // namespace ember
