/// Makes recorded data harder: people in view, a shorter lidar range, dropped scans, an outdated
/// map.
#pragma once

#include "localization/geometry/random.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// Modifications of the recorded data. The defaults change nothing.
struct StressConfig {
  double blocked_share = 0.0;   ///< In [0, 1): share of beams that end at people near the robot.
  double range_max = 0.0;       ///< [m] Longer returns are dropped; 0 keeps all.
  bool odd_scans_only = false;  ///< Scans of even index are dropped; their odometry is kept.
  double erased_share = 0.0;    ///< In [0, 1]: share of the map's wall tiles (1 m) that are erased.
  double boxes_per_m2 = 0.0;    ///< [1/m^2] Boxes of 0.5 m drawn into the map's free space.
};

/// Throws std::invalid_argument if a value is out of range.
void validate(const StressConfig& config);

/// Applies the config to the frames. People are 0.5 m wide and stand 0.6 to 2.5 m away, at new
/// places in every scan. They are added until the share of beams is reached. A beam that ends
/// before a person is unchanged. Beams of 3-D lidars, which stand upright, pass above 1.75 m.
Frames apply_stress(const Frames& frames, const StressConfig& config, localization::Rng& rng);

/// Applies the config to the map.
RosMap damage_map(const RosMap& map, const StressConfig& config, localization::Rng& rng);

}  // namespace castaway::testbed
