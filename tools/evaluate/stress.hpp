/// Makes recorded data harder: people in the view, a short-sighted lidar, scans left out, a map
/// that is out of date.
#pragma once

#include "localization/geometry/random.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/sources/recorded_source.hpp"

namespace castaway::testbed {

/// What is made harder. Defaults: nothing.
struct StressConfig {
  double blocked_share = 0.0;  ///< In [0, 1): share of the beams that end at people near the robot.
  double range_max = 0.0;      ///< [m] Longer returns are lost; 0: none.
  bool odd_scans_only = false;  ///< Scans of even index are left out, their odometry stays.
  double erased_share = 0.0;  ///< In [0, 1]: share of the map's wall tiles (1 m) that are erased...
  double boxes_per_m2 =
      0.0;  ///< ...and boxes of 0.5 m that are drawn into its free space per square metre.
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const StressConfig& config);

/// The frames as the config makes them. People stand 0.6 to 2.5 m away, 0.5 m wide, in other places
/// in every scan, until the share of beams is reached; a beam that ends before them stays.
Frames stressed(const Frames& frames, const StressConfig& config, localization::Rng& rng);

/// The map as the config makes it.
RosMap damaged(const RosMap& map, const StressConfig& config, localization::Rng& rng);

}  // namespace castaway::testbed
