/// A floor for benchmarks: 40 x 30 m at 5 cm, forty rooms that are alike.
#pragma once

#include "localization/map/occupancy_grid.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::bench {

/// Rooms of 5 x 4 m in pairs of rows along corridors, each with a door and a desk at nearly the
/// same place.
localization::OccupancyGrid office_floor();

/// A scan of 180 beams around `T_map_base`, up to 12 m, in base coordinates; `noise` [m] is
/// uniform, a share `blocked` of the beams ends at people 1 m away.
localization::ScanPoints scan_of_floor(const localization::OccupancyGrid& floor,
                                       const localization::SE2& T_map_base, double noise,
                                       double blocked);

/// A pose in the middle of a room.
inline constexpr double kRoomX = 12.0;
inline constexpr double kRoomY = 2.2;

}  // namespace castaway::bench
