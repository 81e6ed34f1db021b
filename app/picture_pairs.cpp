#include "app/picture_pairs.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/difference_report.h"
#include "app/exit_code.h"
#include "app/version.h"
#include "app/xml_text.h"

namespace ember {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

Image picture(const fs::path& file) {
    try {
        return read_image(file);
    } catch (const std::runtime_error& e) {
        throw InputError(e.what());
    }
}

std::set<std::string> pictures_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".png" && name[0] != '.') names.insert(name);
    }
    return names;
}

std::vector<std::string> made_otherwise(const PicturePair& pair) {
    std::vector<std::string> keywords;
    const ImageText expected = read_png_text(pair.expected), drawn = read_png_text(pair.drawn);
    for (const auto& [keyword, value] : expected) {
        const std::string* other = find_text(drawn, keyword);
        // the hash follows from the others
        if (keyword != "Hash" && (other == nullptr || *other != value)) keywords.push_back(keyword);
    }
    return keywords;
}

// What a picture says of itself; presets are long, and `emberleaf show` has them.
std::string said(const fs::path& file, const std::string& keyword) {
    const ImageText text = read_png_text(file);
    const std::string* value = find_text(text, keyword);
    return value == nullptr ? "nothing" : keyword == "Preset" ? "another" : *value;
}

std::string count_text(const ImageDifference& d) {
    return std::to_string(d.pixels) + " of " + std::to_string(d.total) +
           " pixels differ, by up to " + std::to_string(d.max_difference) +
           (d.max_difference == 1 ? " level" : " levels");
}

// JSON has no infinity.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json metrics(const ImageDifference& d, const DifferenceLimits& limits) {
    return {{"pixels", d.total},
            {"pixels_different", d.pixels},
            {"pixels_over_fail", d.pixels_over(limits.fail)},
            {"percent_over_fail", d.percent_over(limits.fail)},
            {"max", d.max_difference},
            {"max_at", {d.max_x, d.max_y}},
            {"mean", d.mean},
            {"rms", d.rms},
            {"psnr", number(d.psnr())},
            {"worst_block", d.worst_block},
            {"worst_block_at", {d.block_x, d.block_y}}};
}

}  // namespace

std::vector<PicturePair> find_pairs(const fs::path& expected, const fs::path& drawn) {
    if (fs::is_directory(expected) != fs::is_directory(drawn))
        throw InputError(drawn.string() + ": error: two files or two folders are compared");
    if (!fs::is_directory(expected)) return {{drawn.filename().string(), expected, drawn}};
    std::set<std::string> names = pictures_in(expected);
    names.merge(pictures_in(drawn));
    if (names.empty()) throw InputError(expected.string() + ": error: holds no PNG files");
    std::vector<PicturePair> pairs;
    pairs.reserve(names.size());
    for (const std::string& name : names)
        pairs.push_back({name, expected / name, drawn / name});
    return pairs;
}

PairResult compare_pair(const PicturePair& pair, const DifferenceLimits& limits) {
    PairResult result{pair, false, "", {}, {}};
    // of two files that were named, each must be there; of folders' files, one may be missing
    const bool of_folders = pair.expected.filename() == pair.drawn.filename() &&
                            (fs::exists(pair.expected) || fs::exists(pair.drawn));
    for (const auto& [file, text] : {std::pair(pair.expected, "not expected: no such reference"),
                                     std::pair(pair.drawn, "missing: was not drawn")}) {
        if (!of_folders || fs::exists(file)) continue;
        result.text = text;
        return result;
    }
    const Image expected = picture(pair.expected), drawn = picture(pair.drawn);
    result.difference = compare(expected, drawn);
    result.made_otherwise = made_otherwise(pair);
    result.text = excess(result.difference, limits);
    result.same = result.text.empty();
    if (result.difference.identical())
        result.text = "equal";
    else if (result.same)
        result.text = "within the limits: " + count_text(result.difference);
    if (!result.difference.comparable) {
        result.text += ": " + std::to_string(expected.width) + 'x' +
                       std::to_string(expected.height) + " and " + std::to_string(drawn.width) +
                       'x' + std::to_string(drawn.height);
    }
    return result;
}

std::string results_json(const std::vector<PairResult>& results, const DifferenceLimits& limits) {
    Json json = {{"schema", kSchema},
                 {"program", "emberleaf"},
                 {"version", kVersion},
                 {"limits",
                  {{"fail", limits.fail},
                   {"fail_percent", limits.fail_percent},
                   {"hard_fail", limits.hard_fail},
                   {"block", number(limits.block)}}}};
    json["same"] =
        std::all_of(results.begin(), results.end(), [](const PairResult& r) { return r.same; });
    json["pictures"] = Json::array();
    for (const PairResult& r : results) {
        json["pictures"].push_back(
            {{"name", r.pair.name},
             {"ref", r.pair.expected.string()},
             {"new", r.pair.drawn.string()},
             {"same", r.same},
             {"exact", r.difference.identical()},
             {"text", r.text},
             {"made_otherwise", r.made_otherwise},
             {"metrics", r.difference.comparable ? metrics(r.difference, limits) : Json(nullptr)}});
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string results_junit(const std::vector<PairResult>& results) {
    const auto failures =
        std::count_if(results.begin(), results.end(), [](const PairResult& r) { return !r.same; });
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"emberleaf diff\""
        " tests=\"" +
        std::to_string(results.size()) + "\" failures=\"" + std::to_string(failures) + "\">\n";
    for (const PairResult& r : results) {
        out += " <testcase classname=\"emberleaf.diff\" name=\"" + xml_escaped(r.pair.name) + "\">";
        if (!r.same)
            out += "<failure message=\"" + xml_escaped(r.text) + "\"/>";
        else
            out += "<system-out>" + xml_escaped(r.text) + "</system-out>";
        out += "</testcase>\n";
    }
    return out + "</testsuite>\n";
}

std::string results_html(const std::vector<PairResult>& results) {
    std::vector<ReportEntry> entries;
    for (const PairResult& r : results) {
        if (r.same) continue;
        ReportEntry entry{r.pair.name, r.text, {}, {}, {}};
        if (fs::exists(r.pair.expected)) entry.expected = picture(r.pair.expected);
        if (fs::exists(r.pair.drawn)) entry.actual = picture(r.pair.drawn);
        for (const std::string& keyword : r.made_otherwise) {
            entry.facts.emplace_back(keyword + ", expected", said(r.pair.expected, keyword));
            entry.facts.emplace_back(keyword + ", new", said(r.pair.drawn, keyword));
        }
        entries.push_back(std::move(entry));
    }
    return difference_report("Pictures that differ", entries);
}

}  // namespace ember
