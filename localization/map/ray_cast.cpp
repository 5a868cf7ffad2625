#include "localization/map/ray_cast.hpp"

#include <cmath>
#include <limits>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

/// Traversal along one axis: its step, and the ray lengths at cell borders.
struct Axis {
  int step = 0;
  double next = std::numeric_limits<double>::infinity();   ///< Length at the next border.
  double pitch = std::numeric_limits<double>::infinity();  ///< Length from border to border.

  Axis(double from, double direction) {
    if (direction == 0.0) return;
    step = direction > 0.0 ? 1 : -1;
    const double border = direction > 0.0 ? std::floor(from) + 1.0 : std::floor(from);
    next = (border - from) / direction;
    pitch = 1.0 / std::abs(direction);
  }
};

bool is_free(const OccupancyGrid& grid, const Eigen::Vector2i& cell) {
  return grid.frame.contains(cell) && grid.cells[grid.frame.index(cell)] == CellState::kFree;
}

}  // namespace

double cast_ray(const OccupancyGrid& grid, const Eigen::Vector2d& from_cells,
                const Eigen::Vector2d& direction, double longest) {
  Eigen::Vector2i cell(cell_index(from_cells.x()), cell_index(from_cells.y()));
  Axis x(from_cells.x(), direction.x());
  Axis y(from_cells.y(), direction.y());
  double length = 0.0;
  while (is_free(grid, cell)) {
    Axis& axis = x.next < y.next ? x : y;
    length = axis.next;
    if (length >= longest) return longest;
    axis.next += axis.pitch;
    (&axis == &x ? cell.x() : cell.y()) += axis.step;
  }
  return length;
}

}  // namespace castaway::localization
