// Pictures that differ, side by side in one HTML file that needs nothing else to be read.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/image_difference.h"

namespace ember {

struct ReportEntry {
    std::string name, verdict;  ///< a verdict may have several lines
    std::optional<Image> expected, actual;
    std::vector<std::pair<std::string, std::string>> facts;  ///< name and value
};

/// The whole document: for each entry what was expected, what was drawn, their difference 16 times
/// as strong, a heat map, and figures. Pictures are within it.
[[nodiscard]] std::string difference_report(const std::string& title,
                                            std::span<const ReportEntry> entries);

}  // namespace ember
