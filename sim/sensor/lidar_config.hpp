/// What a lidar is and where it sits.
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "sim/sensor/light_effects.hpp"
#include "sim/sensor/range_noise.hpp"

namespace castaway::sim {

/// A lidar. Beam i points to `angle_min + i * angle_increment` about the laser's z, of a 3-D lidar
/// once for each layer.
struct LidarConfig {
  std::string name = "lidar";   ///< Unique on its robot; names its streams of random numbers.
  std::string frame = "laser";  ///< Frame id of its scans.
  Eigen::Isometry3d T_base_laser{Eigen::Translation3d(0.0, 0.0, 0.2)};  ///< Any mount in 3-D.
  int beams = 360;                                                      ///< [1, 100000] A layer.
  double angle_min = -std::numbers::pi;                                 ///< [rad]
  double angle_increment = 2.0 * std::numbers::pi / 360;                ///< [rad] Signed.
  std::vector<double> elevations = {0.0};  ///< [rad] Of the layers above the laser's plane.
  std::optional<int> planar_layer{};       ///< Layer that stands for a 3-D lidar where a planar
                                           ///< scan is wanted; nothing: the one nearest to level.
  double range_min = 0.12;                 ///< [m] Shorter returns are reported as -inf.
  double range_max = 12.0;                 ///< [m] Longer returns are reported as +inf.
  double rate_hz = 10.0;                   ///< [Hz] Turns a second.
  bool sweep = true;  ///< Each beam at its own time; false: all at the stamp of the scan.
  RangeNoise noise;
  LightEffects light{};
  Intensity intensity = Intensity::kNone;
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const LidarConfig& config);

/// Where beam `index` of a scan, layer by layer, points in the laser's frame. Unit.
Eigen::Vector3d beam_direction(const LidarConfig& config, std::size_t index);
/// The point of base that lies `range` [m] along it.
Eigen::Vector3d beam_point(const LidarConfig& config, std::size_t index, double range);

/// The layer that stands for all: `planar_layer`, or the one nearest to the laser's plane.
int level_layer(const LidarConfig& config);
/// The same lidar with that layer alone.
LidarConfig level_slice(LidarConfig config);

}  // namespace castaway::sim
