#include "tools/build/map_conversion.hpp"

#include <algorithm>

namespace castaway::testbed {

localization::OccupancyGrid to_occupancy_grid(const RosMap& map) {
  using localization::CellState;
  localization::OccupancyGrid grid;
  grid.frame = {
      map.width, map.height, map.resolution, {map.origin_x, map.origin_y, map.origin_yaw}};
  grid.cells.resize(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), grid.cells.begin(), [](std::int8_t p) {
    if (p >= 65) return CellState::kOccupied;
    return p >= 0 && p < 20 ? CellState::kFree : CellState::kUnknown;
  });
  return grid;
}

}  // namespace castaway::testbed
