// The benches that measure: what they write and print, not how fast anything is.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "child.h"
#include "temporary_folder.h"

namespace ember {
namespace {

// The rows of a table, each by the names of its columns.
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');)
        cells.push_back(cell);
    return cells;
}

std::vector<Row> rows_of(const std::string& csv) {
    std::istringstream in(csv);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = cells_of(line);
    std::vector<Row> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> cells = cells_of(line);
        EXPECT_EQ(cells.size(), names.size()) << line;
        Row row;
        for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i)
            row[names[i]] = cells[i];
        rows.push_back(row);
    }
    return rows;
}

double number(const Row& row, const std::string& column) {
    return row.count(column) != 0 ? std::stod(row.at(column)) : -1.0;
}

// Runs a bench in the folder, and returns what it prints, line by line.
std::vector<std::string> printed(const TemporaryFolder& folder,
                                 const std::vector<std::string>& arguments) {
    ChildOptions options;
    options.folder = folder.path();
    const ChildResult result = run_emberleaf(arguments, options);
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    std::vector<std::string> lines;
    std::istringstream in(result.out);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

// The number behind "(springs ", and that behind "coupling ".
void expect_times(const std::string& line, double springs, double fire) {
    const auto behind = [&line](const std::string& word) {
        const std::size_t at = line.find(word);
        return at == std::string::npos ? -1.0 : std::stod(line.substr(at + word.size()));
    };
    EXPECT_NEAR(behind("(springs "), springs, 1e-3 + 1e-4 * springs) << line;
    EXPECT_NEAR(behind("coupling "), fire, 1e-3 + 1e-4 * fire) << line;
}

TEST(Benches, ScalingTellsSpringsAndFireApart) {
    const TemporaryFolder folder;
    const auto lines = printed(folder, {"bench", "scaling", "--quick", "--threads", "2"});
    const auto rows = rows_of(folder.read("out/bench/scaling.csv"));
    ASSERT_EQ(rows.size(), 12u) << "three lattices, one and two threads, two fires";
    ASSERT_EQ(lines.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        SCOPED_TRACE(lines[i]);
        EXPECT_GT(number(row, "ms springs"), 0);
        expect_times(lines[i], number(row, "ms springs"),
                     number(row, "ms fire") + number(row, "ms coupling"));
        const bool burns = number(row, "particles") > 0;
        EXPECT_EQ(number(row, "coupling pairs") > 0, burns);
        EXPECT_GT(number(row, "right-hand sides"), number(row, "sub-steps"));
    }
    for (const char* chart : {"threads", "stages", "particles"}) {
        const std::string svg = folder.read("out/bench/scaling_" + std::string(chart) + ".svg");
        EXPECT_NE(svg.find("</svg>"), std::string::npos) << chart;
    }
}

TEST(Benches, StagesFollowABurn) {
    const TemporaryFolder folder;
    const auto lines =
        printed(folder, {"bench", "stages", "paper/corner", "--quick", "--threads", "1"});
    const auto rows = rows_of(folder.read("out/bench/stages.csv"));
    ASSERT_EQ(rows.size(), 3u);
    ASSERT_EQ(lines.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        expect_times(lines[i], number(row, "ms per tick springs"),
                     number(row, "ms per tick fire") + number(row, "ms per tick coupling"));
        EXPECT_EQ(number(row, "simulated second"), static_cast<double>(i + 1));
        EXPECT_GT(number(row, "particles moved per tick"), 0);
    }
    EXPECT_GT(number(rows[2], "nodes burning per tick"), number(rows[0], "nodes burning per tick"));
    EXPECT_NE(folder.read("out/bench/stages_paper_corner.svg").find("</svg>"), std::string::npos);
}

TEST(Benches, WorkPrecisionComparesAllMethodsOnOneProblem) {
    const TemporaryFolder folder;
    (void)printed(folder, {"bench", "work-precision", "--quick", "--problem", "swing"});
    const auto rows = rows_of(folder.read("out/bench/swing.csv"));
    std::map<std::string, int> settings;
    for (const Row& row : rows) {
        EXPECT_GT(number(row, "right-hand sides"), 0);
        if (row.at("method") != "auto") ++settings[row.at("method")];  // that has none
    }
    EXPECT_GE(settings.size(), 5u);
    for (const auto& [method, count] : settings)
        EXPECT_GE(count, 7) << method;
}

}  // namespace
}  // namespace ember
