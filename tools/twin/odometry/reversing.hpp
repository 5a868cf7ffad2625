/// Odometry that counts reversing as driving ahead.
#pragma once

#include <vector>

#include "tools/twin/alignment/motion_samples.hpp"

namespace castaway::testbed {

/// True if odometry drives ahead in most of the legs in which the robot reverses on the map, and
/// there are at least ten.
bool is_distance_unsigned(const std::vector<Leg>& legs);

/// The legs with the sign of the distance from the map.
std::vector<Leg> sign_distances(std::vector<Leg> legs);

}  // namespace castaway::testbed
