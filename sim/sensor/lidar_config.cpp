#include "sim/sensor/lidar_config.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/robot/robot_model.hpp"

namespace castaway::sim {
namespace {

void require(bool condition, const char* field, double value, const char* remedy) {
  if (condition) return;
  throw std::invalid_argument(fmt::format("lidar: {} is {}: {}", field, value, remedy));
}

}  // namespace

void validate(const LidarConfig& c) {
  require(c.beams >= 1 && c.beams <= 100000, "beams", c.beams, "give 1 to 100000");
  require(std::isfinite(c.angle_min), "angle_min", c.angle_min, "give an angle in radians");
  require(c.angle_increment != 0.0 && std::abs(c.angle_increment) * c.beams < 6.2832,
          "angle_increment", c.angle_increment,
          "give a step such that the beams make at most one turn, the last not on the first");
  require(c.range_min >= 0.0, "range_min", c.range_min, "give 0 or more");
  require(c.range_max > c.range_min, "range_max", c.range_max, "give more than range_min");
  require(c.rate_hz > 0.0 && c.rate_hz <= 1000.0, "rate_hz", c.rate_hz, "give 0 to 1000");
  require(c.noise.sigma >= 0.0, "noise.sigma", c.noise.sigma, "give 0 or more");
}

LidarConfig lidar_of(const RobotModel& robot) {
  LidarConfig config;
  if (!robot.lidar) return config;
  config.T_base_laser = robot.lidar->T_base_laser;
  if (!robot.lidar->specs) return config;
  const LidarSpecs& specs = *robot.lidar->specs;
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
  return config;
}

}  // namespace castaway::sim
