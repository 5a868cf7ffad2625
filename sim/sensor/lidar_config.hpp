/// Configuration of a lidar.
#pragma once

#include <chrono>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/sensor/light_effects.hpp"
#include "sim/sensor/range_noise.hpp"

namespace castaway::sim {

/// A lidar. Beam i points to `angle_min + i * angle_increment` about the laser's z axis; a 3-D
/// lidar has one such beam in each layer.
struct LidarConfig {
  std::string name = "lidar";   ///< Unique on its robot; names its random streams.
  std::string frame = "laser";  ///< Frame id of its scans.
  Eigen::Isometry3d T_base_laser{Eigen::Translation3d(0.0, 0.0, 0.2)};  ///< Mount; any pose in 3-D.
  int beams = 360;                                                      ///< Per layer, [1, 100000].
  double angle_min = -std::numbers::pi;                                 ///< [rad]
  double angle_increment = 2.0 * std::numbers::pi / 360;                ///< [rad] Signed.
  std::vector<double> elevations = {0.0};  ///< [rad] Of the layers above the laser's plane.
  /// Layer used where a planar scan is needed; nothing: the one nearest to level.
  std::optional<int> planar_layer{};
  double range_min = 0.12;  ///< [m] Shorter returns are reported as -inf.
  double range_max = 12.0;  ///< [m] Longer returns are reported as +inf.
  double rate_hz = 10.0;    ///< [Hz] Revolutions per second.
  /// Times at which scans begin, ascending; empty: all the time. A scan begins after the end of the
  /// one before.
  std::vector<std::chrono::nanoseconds> scan_times{};
  double stamp_sigma = 0.0;  ///< [s] Standard deviation of the error of a scan's stamp.
  bool sweep = true;         ///< Each beam has its own time; false: all have the scan's stamp.
  RangeNoise noise;
  LightEffects light{};
  Intensity intensity = Intensity::kNone;
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const LidarConfig& config);

/// Unit vector of beam `index`, counted layer by layer, in the laser's frame.
Eigen::Vector3d beam_direction(const LidarConfig& config, std::size_t index);
/// The point in base at `range` [m] along that beam.
Eigen::Vector3d beam_point(const LidarConfig& config, std::size_t index, double range);

/// The layer that a planar scan is taken from: `planar_layer`, or the one nearest to the laser's
/// plane.
int level_layer(const LidarConfig& config);
/// The same lidar with only that layer.
LidarConfig level_slice(LidarConfig config);

}  // namespace castaway::sim
