/// Maps for tests, drawn as text: '#' occupied, '.' free, ' ' unknown; the first line is the top
/// row.
#pragma once

#include <string>
#include <vector>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::test {

inline localization::OccupancyGrid string_map(const std::vector<std::string>& rows,
                                              double resolution,
                                              const localization::SE2& T_map_grid = {}) {
  using localization::CellState;
  localization::OccupancyGrid grid;
  grid.frame = {static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), resolution,
                T_map_grid};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      grid.cells.push_back(c == '#'   ? CellState::kOccupied
                           : c == '.' ? CellState::kFree
                                      : CellState::kUnknown);
    }
  }
  return grid;
}

}  // namespace castaway::test
