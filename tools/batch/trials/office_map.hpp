/// A generated office with many nearly identical rooms: perceptual aliasing makes global
/// localization hard.
#pragma once

#include <cstdint>

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Parameters of the generated floor.
struct OfficeSpec {
  double width = 40.0;       ///< [m] At least 10.
  double height = 30.0;      ///< [m] At least 10.
  double resolution = 0.05;  ///< [m]
  std::uint64_t seed = 1;    ///< Seed of doors and furniture.
};

/// Draws the floor. Corridors 2 m wide run along x, 10 m apart, with a row of rooms on either side;
/// cross corridors along y are 40 m apart. Rooms are about 4.8 x 3.8 m. Each has a door to its
/// corridor and a desk, a cupboard and sometimes a second desk at nearly the same places. Cabinets
/// stand in the corridors. Every cell is free or occupied; the origin is the lower left corner.
/// Throws std::invalid_argument if a value is out of range.
RosMap draw_office(const OfficeSpec& spec = {});

}  // namespace castaway::testbed
