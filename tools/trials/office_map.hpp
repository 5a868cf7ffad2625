/// An office drawn by program: many rooms that are nearly alike, which is what makes global
/// localization hard.
#pragma once

#include <cstdint>

#include "tools/formats/ros_map.hpp"

namespace castaway::testbed {

/// The floor to draw.
struct OfficeSpec {
  double width = 40.0;       ///< [m] At least 10.
  double height = 30.0;      ///< [m] At least 10.
  double resolution = 0.05;  ///< [m]
  std::uint64_t seed = 1;    ///< Of doors and furniture.
};

/// Corridors of 2 m along x, 10 m apart, with a row of rooms on either side; others along y link
/// them, 40 m apart. Rooms are about 4.8 x 3.8 m, each with a door to its corridor and a desk, a
/// cupboard and sometimes a second desk at nearly the same places; cabinets stand in the corridors.
/// Every cell is free or occupied; the origin is the lower left corner. Throws
/// std::invalid_argument where a figure is out of its range.
RosMap draw_office(const OfficeSpec& spec = {});

}  // namespace castaway::testbed
