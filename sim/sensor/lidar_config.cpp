#include "sim/sensor/lidar_config.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr int kMostRays = 1000000;

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
          "give a step such that all beams fit into one turn, without the last on the first");
  require(c.range_min >= 0.0, "range_min", c.range_min, "give 0 or more");
  require(c.range_max > c.range_min, "range_max", c.range_max, "give more than range_min");
  require(c.rate_hz > 0.0 && c.rate_hz <= 1000.0, "rate_hz", c.rate_hz, "give 0 to 1000");
  require(!c.elevations.empty() && c.elevations.size() <= 1024, "number of elevations",
          static_cast<double>(c.elevations.size()), "give 1 to 1024 layers");
  for (const double elevation : c.elevations) {
    require(std::abs(elevation) < 0.5 * std::numbers::pi, "elevation", elevation,
            "give less than pi / 2 radians");
  }
  const int layers = static_cast<int>(c.elevations.size());
  require(c.beams <= kMostRays / layers, "number of rays of a sweep",
          static_cast<double>(c.beams) * layers, "give at most a million, beams times layers");
  const int planar = c.planar_layer.value_or(0);
  require(planar >= 0 && planar < layers, "localize_layer", planar,
          "give the index of a layer, counted from 0");
  if (!std::is_sorted(c.scan_times.begin(), c.scan_times.end())) {
    throw std::invalid_argument("lidar: its scan times go back: sort them");
  }
  if (!c.scan_times.empty() && c.scan_times.front().count() < 0) {
    throw std::invalid_argument("lidar: a scan time is negative: count from the start of the run");
  }
  require(c.stamp_sigma >= 0.0 && c.stamp_sigma <= 10.0, "stamp_sigma_s", c.stamp_sigma,
          "give 0 to 10");
  validate(c.noise);
  validate(c.light);
}

Eigen::Vector3d beam_direction(const LidarConfig& config, std::size_t index) {
  const auto beams = static_cast<std::size_t>(config.beams);
  const double angle =
      config.angle_min + config.angle_increment * static_cast<double>(index % beams);
  const double elevation = config.elevations[index / beams];
  const double level = std::cos(elevation);
  return {level * std::cos(angle), level * std::sin(angle), std::sin(elevation)};
}

Eigen::Vector3d beam_point(const LidarConfig& config, std::size_t index, double range) {
  return config.T_base_laser * Eigen::Vector3d(range * beam_direction(config, index));
}

int level_layer(const LidarConfig& config) {
  if (config.planar_layer) return *config.planar_layer;
  const auto& e = config.elevations;
  const auto level = std::min_element(e.begin(), e.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); });
  return static_cast<int>(level - e.begin());
}

LidarConfig level_slice(LidarConfig config) {
  config.elevations = {config.elevations[static_cast<std::size_t>(level_layer(config))]};
  config.planar_layer.reset();
  return config;
}

}  // namespace castaway::sim
