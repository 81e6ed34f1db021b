#include "sim/mask_image.h"

#include <algorithm>

namespace ember {
namespace {

// Lengths are in parts of which a pixel has `cells` and a cell has `pixels`, so that both are
// whole.
struct Axis {
    std::int64_t pixels, cells;
    [[nodiscard]] std::int64_t first_pixel(std::int64_t cell) const {
        return cell * pixels / cells;
    }
    [[nodiscard]] std::int64_t overlap(std::int64_t cell, std::int64_t pixel) const {
        const std::int64_t begin = std::max(cell * pixels, pixel * cells);
        const std::int64_t end = std::min((cell + 1) * pixels, (pixel + 1) * cells);
        return std::max<std::int64_t>(0, end - begin);
    }
};

}  // namespace

std::vector<std::uint8_t> paper_cells(const MaskImage& image, int rows, int columns) {
    const Axis across{image.width, rows}, along{image.height, columns};
    std::vector<std::uint8_t> cells;
    cells.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    for (std::int64_t row = 0; row < rows; ++row) {
        for (std::int64_t column = 0; column < columns; ++column) {
            std::int64_t covered = 0;
            for (std::int64_t y = along.first_pixel(column);
                 y < image.height && along.overlap(column, y) > 0; ++y) {
                std::int64_t in_line = 0;
                for (std::int64_t x = across.first_pixel(row);
                     x < image.width && across.overlap(row, x) > 0; ++x) {
                    const std::int64_t pixel = y * image.width + x;
                    if (image.paper[static_cast<std::size_t>(pixel)] != 0)
                        in_line += across.overlap(row, x);
                }
                covered += in_line * along.overlap(column, y);
            }
            const std::int64_t whole = std::int64_t{image.width} * image.height;
            cells.push_back(2 * covered >= whole ? 1 : 0);
        }
    }
    return cells;
}

}  // namespace ember
