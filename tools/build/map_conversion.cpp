#include "tools/build/map_conversion.hpp"

namespace castaway::testbed {

localization::OccupancyGrid to_occupancy_grid(const RosMap& map) {
  return localization::trinary_grid(
      {map.width, map.height, map.resolution, {map.origin_x, map.origin_y, map.origin_yaw}},
      map.cells);
}

}  // namespace castaway::testbed
