#include "localization/map/chebyshev_field.hpp"

#include <algorithm>
#include <cassert>

namespace castaway::localization {
namespace {

/// Lowers a value to one more than the least of three adjacent ones and `beside`.
void lower(std::uint8_t& value, const std::uint8_t* three, std::uint8_t beside) {
  const int least = std::min({three[0], three[1], three[2], beside});
  value = static_cast<std::uint8_t>(std::min<int>(value, least + 1));
}

/// The two passes of the chamfer transform, which is exact for this distance; the outermost cells
/// keep their values.
void transform(std::size_t columns, std::size_t rows, std::vector<std::uint8_t>& values) {
  for (std::size_t r = 1; r + 1 < rows; ++r) {
    std::uint8_t* line = values.data() + r * columns;
    for (std::size_t c = 1; c + 1 < columns; ++c)
      lower(line[c], line + c - columns - 1, line[c - 1]);
  }
  for (std::size_t r = rows - 1; r-- > 1;) {
    std::uint8_t* line = values.data() + r * columns;
    for (std::size_t c = columns - 1; c-- > 1;) {
      lower(line[c], line + c + columns - 1, line[c + 1]);
    }
  }
}

}  // namespace

ChebyshevField::ChebyshevField(const OccupancyGrid& grid, int cap)
    : cap_(cap),
      columns_(static_cast<std::size_t>(grid.frame.width + 2 * cap)),
      rows_(static_cast<std::size_t>(grid.frame.height + 2 * cap)),
      values_(columns_ * rows_, static_cast<std::uint8_t>(cap)) {
  assert(cap >= 1 && cap <= 255);
  validate(grid);
  const auto padding = static_cast<std::size_t>(cap);
  const auto width = static_cast<std::size_t>(grid.frame.width);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] != CellState::kOccupied) continue;
    values_[(i / width + padding) * columns_ + i % width + padding] = 0;
  }
  transform(columns_, rows_, values_);
}

}  // namespace castaway::localization
