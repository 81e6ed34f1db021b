// Words within XML: charts, reports, JUnit.
#pragma once

#include <string>
#include <string_view>

namespace ember {

/// `words` with the five characters that XML reserves escaped.
[[nodiscard]] std::string xml_escaped(std::string_view words);

}  // namespace ember
