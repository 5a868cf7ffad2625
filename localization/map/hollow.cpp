#include "localization/map/hollow.hpp"

#include <algorithm>

#include "localization/map/distance_field.hpp"

namespace castaway::localization {
namespace {

/// The map with all cells that are not occupied as the walls.
OccupancyGrid inverted(const OccupancyGrid& grid) {
  OccupancyGrid result = grid;
  std::transform(grid.cells.begin(), grid.cells.end(), result.cells.begin(), [](CellState state) {
    return state == CellState::kOccupied ? CellState::kFree : CellState::kOccupied;
  });
  return result;
}

}  // namespace

OccupancyGrid hollow(const OccupancyGrid& grid, double depth) {
  const double cell = grid.frame.resolution;
  const double most = std::max(depth, cell) + 1e-3 * cell;  // Whole cells stay whole.
  const DistanceField to_surface(inverted(grid), most + cell);
  OccupancyGrid result = grid;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    if (to_surface.values()[i] > most) result.cells[i] = CellState::kUnknown;
  }
  return result;
}

}  // namespace castaway::localization
