#include "localization/sensor/beam_model.hpp"

#include <cmath>
#include <stdexcept>

#include "localization/map/ray_cast.hpp"
#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {
namespace {

double cube(double x) { return x * x * x; }

}  // namespace

void validate(const BeamModelConfig& config) {
  for (const double z : {config.z_hit, config.z_short, config.z_max, config.z_rand}) {
    if (!(z >= 0.0)) {
      throw std::invalid_argument("z_hit, z_short, z_max, z_rand must not be negative");
    }
  }
  if (!(config.sigma_hit > 0.0)) throw std::invalid_argument("sigma_hit must be positive");
  if (!(config.lambda_short > 0.0)) throw std::invalid_argument("lambda_short must be positive");
}

BeamModel::BeamModel(const BeamModelConfig& config, const OccupancyGrid& grid)
    : config_((validate(config), config)), grid_(grid) {}

double BeamModel::hit(double error) const {
  const double z = error / config_.sigma_hit;
  return config_.z_hit * std::exp(-0.5 * z * z);
}

double BeamModel::return_probability(double range, double expected, double range_max) const {
  double pz = hit(range - expected) + config_.z_rand / range_max;
  if (range < expected) {
    pz += config_.z_short * config_.lambda_short * std::exp(-config_.lambda_short * range);
  }
  return pz;
}

double BeamModel::miss_probability(double expected, double range_max) const {
  return hit(range_max - expected) + config_.z_max;
}

std::vector<double> BeamModel::expected_ranges(const ScanPoints& points, const SE2& T_map_base,
                                               double range_max) const {
  const double resolution = grid_.frame.resolution;
  const PoseInCells pose(grid_.frame, T_map_base);
  std::vector<double> expected;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d from(pose.x(points.origin_x[i], points.origin_y[i]),
                               pose.y(points.origin_x[i], points.origin_y[i]));
    const Eigen::Vector2d end(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i]));
    expected.push_back(resolution *
                       cast_ray(grid_, from, (end - from).normalized(), range_max / resolution));
  }
  return expected;
}

double BeamModel::weight(const BeamScan& scan, const SE2& T_map_base, double range_max) const {
  double weight = 1.0;
  const std::vector<double> returns = expected_ranges(scan.returns, T_map_base, range_max);
  for (std::size_t i = 0; i < returns.size(); ++i) {
    const double range = scan.returns.range[i];
    weight += cube(return_probability(range, returns[i], range_max));
  }
  for (const double expected : expected_ranges(scan.misses, T_map_base, range_max)) {
    weight += cube(miss_probability(expected, range_max));
  }
  return weight;
}

}  // namespace castaway::localization
