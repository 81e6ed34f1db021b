// What exists in a scene: the recipe from which a world is built. Never changes afterwards.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "sim/params.h"
#include "sim/types.h"

namespace ember {

/// A scene that cannot be built, and the parameter that is to blame: "sheet.rows", or
/// "sheets.2.rows" of the second element of a list.
class SceneError : public std::invalid_argument {
  public:
    SceneError(std::string key, const std::string& message)
        : std::invalid_argument(key + ": " + message), key_(std::move(key)), message_(message) {}
    [[nodiscard]] const std::string& key() const { return key_; }
    [[nodiscard]] const std::string& message() const { return message_; }

  private:
    std::string key_, message_;
};

/// One sheet before it is built. Local frame: main direction along `main`, cross along `cross`.
struct SheetPlan {
    int rows = 0, columns = 0;     ///< cells in cross (M) and main (N) direction
    double width = 0, height = 0;  ///< [m] cross and main size
    SheetShape shape = SheetShape::Flat;
    Border border = Border::Tributary;
    HeldEdge held = HeldEdge::None;
    std::vector<std::array<double, 3>> held_points;  ///< [m] along main, along cross, radius
    std::vector<std::uint8_t> paper;  ///< rows × columns cells, 1 where there is paper; empty: all
    Vector3 origin = Vector3::Zero();  ///< [m] of site (row 0, column 0)
    Vector3 main = Vector3::UnitX();   ///< unit vector
    Vector3 cross = Vector3::UnitZ();  ///< unit vector; on a tube, the direction at row 0
    double imperfection = 0;           ///< [m] amplitude of the initial waviness
    double gap = 0;                    ///< [m] to the next of its stack, +inf alone
    std::string group = "sheet";       ///< of the keys that describe it: "sheet" or "sheets.2"
    std::string name;                  ///< in messages

    /// Whether cell (row, column) is paper.
    [[nodiscard]] bool is_paper(int row, int column) const {
        return paper.empty() ||
               paper[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column)] != 0;
    }
};

/// Sheets; lighters are parameters, because they are moved while the paper burns.
struct Scene {
    std::vector<SheetPlan> sheets;
};

/// The sheet group of each element of the scene: [sheet] with what the elements of Params::sheets
/// say differently, or [sheet] alone. Each stands for sheet.count sheets.
[[nodiscard]] std::vector<SheetParams> sheets_of(const Params& params);

/// The scene that `params` describe. A sheet is put where its pose says, turned about the middle
/// of the first of its stack (around x, then y, then z), and moved. Throws SceneError when there
/// are more than kMostNodes nodes, before anything is made, or a mask has no picture or no paper.
[[nodiscard]] Scene make_scene(const Params& params);

inline constexpr std::int64_t kMostNodes = 4096ll * 4096ll;

}  // namespace ember
