#include "localization/map/coarsen.hpp"

namespace castaway::localization {

OccupancyGrid coarsen(const OccupancyGrid& grid, int factor) {
  const GridFrame& fine = grid.frame;
  OccupancyGrid coarse;
  coarse.frame = {(fine.width + factor - 1) / factor, (fine.height + factor - 1) / factor,
                  fine.resolution * factor, fine.T_map_grid};
  coarse.cells.assign(coarse.frame.size(), CellState::kUnknown);
  for (int row = 0; row < fine.height; ++row) {
    for (int column = 0; column < fine.width; ++column) {
      const CellState state = grid.cells[fine.index({column, row})];
      CellState& cell = coarse.cells[coarse.frame.index({column / factor, row / factor})];
      if (state == CellState::kOccupied || cell == CellState::kUnknown) cell = state;
    }
  }
  return coarse;
}

}  // namespace castaway::localization
