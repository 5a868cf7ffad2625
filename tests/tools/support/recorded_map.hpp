/// A small map for tests of recordings.
#pragma once

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// 3 x 2 cells of 0.5 m with origin (-1, 2), rotated by 0.25; that of tests/data/recording.
inline RosMap recorded_map() {
  RosMap map;
  map.name = "small";
  map.width = 3;
  map.height = 2;
  map.resolution = 0.5;
  map.origin_x = -1.0;
  map.origin_y = 2.0;
  map.origin_yaw = 0.25;
  map.cells = {0, 0, -1, -1, 100, 60};
  return map;
}

}  // namespace castaway::testbed
