// Where letters beyond ASCII may stand in TOML.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ember {

/// A character, its place (1-based, in characters), and its bytes.
struct ForeignLetter {
    int line = 1, column = 1;
    std::string letter;
};

/// The first character beyond ASCII that stands neither in a string nor in a comment, where TOML
/// has none; a byte order mark at the beginning does not count. Also the quote of a string that
/// begins where none can, if such a character follows anywhere: TOML's readers do not take the rest
/// for a string. To be asked before toml++ 3.3 reads the text: it takes for unreachable what such a
/// letter reaches.
[[nodiscard]] std::optional<ForeignLetter> foreign_letter(std::string_view toml);
/// What is wrong with it.
[[nodiscard]] std::string foreign_letter_text(const ForeignLetter& foreign);

}  // namespace ember
