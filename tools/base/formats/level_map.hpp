/// Maps of the floors of a run, for its pages.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// A floor with the ramps that rise from it.
struct LevelMap {
  double z = 0.0;  ///< [m] Median height of its ground.
  RosMap map;      ///< Ground is the darker the steeper; around it, occupied.
};

/// Ascending in z, at least one. The maps are of one size and frame.
using LevelMaps = std::vector<LevelMap>;

/// Index of the floor on which something at the height `z` [m] is: the last one that is at most
/// 0.5 m above it, or else the first.
std::size_t level_at(const LevelMaps& levels, double z);

}  // namespace castaway::testbed
