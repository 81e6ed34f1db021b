// Where a sheet's paper is, as a black-and-white picture, and what that means for its lattice.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ember {

/// A picture. Its x axis runs along the sheet's cross direction and its y axis, downwards, along
/// the main direction: on a hanging sheet it stands upright for the viewer.
struct MaskImage {
    std::string name;  ///< as sheet.mask says it
    int width = 0, height = 0;
    std::vector<std::uint8_t> paper;  ///< height × width, 1 where there is paper
};

/// The cells of a lattice, rows × columns, that are paper: those of which the picture covers at
/// least half with paper. Exact, so that symmetric pictures give symmetric sheets.
[[nodiscard]] std::vector<std::uint8_t> paper_cells(const MaskImage& image, int rows, int columns);

}  // namespace ember
