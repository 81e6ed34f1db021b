// "Did you mean": the nearest of several words.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ember {

/// The candidate that needs the fewest single-character edits to become `word` (Levenshtein), or
/// empty when all are further away than a slip of the fingers.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       std::span<const std::string_view> candidates);

}  // namespace ember
