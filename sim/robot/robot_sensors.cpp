#include "sim/robot/robot_sensors.hpp"

#include <algorithm>
#include <numbers>

namespace castaway::sim {
namespace {

std::vector<double> elevations_of(const LidarSpecs& specs) {
  if (specs.layers <= 1) return {0.0};
  std::vector<double> elevations;
  const double step = (specs.layer_max - specs.layer_min) / (specs.layers - 1);
  for (int i = 0; i < specs.layers; ++i) elevations.push_back(specs.layer_min + step * i);
  return elevations;
}

constexpr double kFreeOfBody = 0.02;  // [m]

LidarConfig config_of(const LidarMount& mount) {
  LidarConfig config;
  config.T_base_laser = mount.T_base_laser;
  config.frame = mount.link;
  if (!mount.specs) return config;
  const LidarSpecs& specs = *mount.specs;
  config.beams = specs.samples;
  config.angle_min = specs.angle_min;
  const double sweep = specs.angle_max - specs.angle_min;
  const bool full_circle = sweep * (specs.samples + 1) / specs.samples > 2.0 * std::numbers::pi;
  const int gaps = full_circle ? specs.samples : specs.samples - 1;
  const double turn = full_circle ? 2.0 * std::numbers::pi : sweep;
  if (gaps > 0) config.angle_increment = turn / gaps;
  if (specs.range_min > 0.0) config.range_min = specs.range_min;
  if (specs.range_max > 0.0) config.range_max = specs.range_max;
  if (specs.rate_hz > 0.0) config.rate_hz = specs.rate_hz;
  if (specs.sigma) config.noise.sigma = *specs.sigma;
  config.elevations = elevations_of(specs);
  return config;
}

}  // namespace

LidarConfig lidar_of(const RobotModel& robot) {
  if (robot.lidar) return config_of(*robot.lidar);
  LidarConfig config;
  double& z = config.T_base_laser.translation().z();
  z = std::max(z, robot.height + kFreeOfBody);
  return config;
}

std::vector<LidarConfig> lidars_of(const RobotModel& robot) {
  if (robot.lidars.size() < 2) return {lidar_of(robot)};
  std::vector<LidarConfig> lidars;
  for (const LidarMount& mount : robot.lidars) {
    lidars.push_back(config_of(mount));
    lidars.back().name = mount.sensor.empty() ? mount.link : mount.sensor;
    const auto same = std::count_if(lidars.begin(), lidars.end(), [&](const LidarConfig& other) {
      return other.frame != mount.link && other.name == lidars.back().name;
    });
    if (same > 0) lidars.back().name += "_" + mount.link;  // The same macro may be used twice.
  }
  return lidars;
}

DriveGeometry drive_geometry(const RobotModel& robot) {
  return {robot.wheel_radius, robot.wheel_radius, robot.track, robot.p_base_axle};
}

}  // namespace castaway::sim
