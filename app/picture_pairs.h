// Pictures that are compared with those of the same name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/image_difference.h"

namespace ember {

struct PicturePair {
    std::string name;  ///< of the file
    std::filesystem::path expected, drawn;
};

/// What came of a pair.
struct PairResult {
    PicturePair pair;
    bool same = false;  ///< within the limits
    std::string text;   ///< "equal", "within the limits: ...", or what is wrong
    ImageDifference difference;
    /// What the two pictures say differently about how they were made: "Version", "Preset", ...
    std::vector<std::string> made_otherwise;
};

/// Two files, or all PNG files of two folders, whatever stands in only one of them included; sorted
/// by name. Throws InputError when one is a folder and the other a file, or when there is none.
[[nodiscard]] std::vector<PicturePair> find_pairs(const std::filesystem::path& expected,
                                                  const std::filesystem::path& drawn);

/// A picture that stands in one folder only is a difference. Throws InputError when a file cannot
/// be read.
[[nodiscard]] PairResult compare_pair(const PicturePair& pair, const DifferenceLimits& limits);

/// The schema is documented in docs/GOLDEN.md.
[[nodiscard]] std::string results_json(const std::vector<PairResult>& results,
                                       const DifferenceLimits& limits);
/// A test case per pair.
[[nodiscard]] std::string results_junit(const std::vector<PairResult>& results);
/// The pairs that differ, as difference_report has them.
[[nodiscard]] std::string results_html(const std::vector<PairResult>& results);

}  // namespace ember
