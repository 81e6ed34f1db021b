#include "app/preset_io/toml_letters.h"

#include <algorithm>

namespace ember {
namespace {

bool is_foreign(char c) {
    return (static_cast<unsigned char>(c) & 0x80u) != 0;
}

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

// What the quotes at the beginning of `text` open: one, or three for a string of many lines.
std::string_view quotes_at(std::string_view text) {
    if (text.starts_with("\"\"\"") || text.starts_with("'''")) return text.substr(0, 3);
    return text.starts_with('"') || text.starts_with('\'') ? text.substr(0, 1) : "";
}

// Length of the string that begins with `quotes` at the beginning of `text`; of a string that does
// not end, all of its line, or of the text where it may have many lines.
std::size_t string_length(std::string_view text, std::string_view quotes) {
    std::size_t at = quotes.size();
    while (at < text.size() && !text.substr(at).starts_with(quotes)) {
        if (quotes.size() == 1 && text[at] == '\n') return at;
        at += quotes[0] == '"' && text[at] == '\\' ? 2u : 1u;
    }
    if (at >= text.size()) return text.size();
    at += quotes.size();
    // a string of many lines may end with quotes of its own before the three
    while (quotes.size() == 3 && at < text.size() && text[at] == quotes[0])
        ++at;
    return at;
}

ForeignLetter place_of(std::string_view toml, std::size_t at) {
    ForeignLetter found;
    for (std::size_t i = 0; i < at; ++i) {
        if (toml[i] == '\n') {
            ++found.line;
            found.column = 1;
        } else if (!is_continuation(toml[i])) {
            ++found.column;
        }
    }
    std::size_t end = at + 1;
    while (end < toml.size() && is_continuation(toml[end]))
        ++end;
    found.letter = toml.substr(at, end - at);
    return found;
}

}  // namespace

std::optional<ForeignLetter> foreign_letter(std::string_view toml) {
    constexpr std::string_view kMark("\xEF\xBB\xBF");
    constexpr std::string_view kBeforeStrings("\n=,.[{");
    std::size_t at = toml.starts_with(kMark) ? kMark.size() : 0;
    char before = '\n';  // the last character that is no blank
    while (at < toml.size()) {
        const std::string_view rest = toml.substr(at);
        const std::string_view quotes = quotes_at(rest);
        if (is_foreign(rest[0])) return place_of(toml, at);
        if (!quotes.empty()) {
            const bool misplaced = kBeforeStrings.find(before) == std::string_view::npos;
            if (misplaced && std::any_of(rest.begin(), rest.end(), is_foreign))
                return place_of(toml, at);
            at += string_length(rest, quotes);
            before = quotes[0];
        } else if (rest[0] == '#') {
            const std::size_t end = rest.find('\n');
            at += end == std::string_view::npos ? rest.size() : end;
        } else {
            if (rest[0] != ' ' && rest[0] != '\t' && rest[0] != '\r') before = rest[0];
            ++at;
        }
    }
    return std::nullopt;
}

std::string foreign_letter_text(const ForeignLetter& foreign) {
    if (!quotes_at(foreign.letter).empty()) return "a string cannot begin here";
    return "\"" + foreign.letter + "\" can stand in strings and comments only";
}

}  // namespace ember
