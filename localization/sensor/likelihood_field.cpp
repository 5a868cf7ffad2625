#include "localization/sensor/likelihood_field.hpp"

#include <cmath>

#include "localization/map/cell_index.hpp"
#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {

LikelihoodField::LikelihoodField(const LikelihoodFieldConfig& config, const OccupancyGrid& grid)
    : config_(config), distances_(grid, config.max_distance) {
  const auto gaussian = [&](double d) {
    return static_cast<float>(std::exp(-0.5 * d * d / (config_.sigma_hit * config_.sigma_hit)));
  };
  gaussian_.reserve(distances_.values().size());
  for (const float d : distances_.values()) gaussian_.push_back(gaussian(static_cast<double>(d)));
  outside_ = gaussian(config_.max_distance);
}

float LikelihoodField::gaussian_at(float x_cells, float y_cells) const {
  const Eigen::Vector2i cell(cell_index(x_cells), cell_index(y_cells));
  const GridFrame& frame = distances_.frame();
  return frame.contains(cell) ? gaussian_[frame.index(cell)] : outside_;
}

double LikelihoodField::weight(const ScanPoints& points, const SE2& T_map_base,
                               double range_max) const {
  const PoseInCells pose(distances_.frame(), T_map_base);
  const double z_rand = config_.z_rand / range_max;
  double weight = 1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float g = gaussian_at(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i]));
    const double pz = config_.z_hit * static_cast<double>(g) + z_rand;
    weight += pz * pz * pz;
  }
  return weight;
}

std::vector<double> LikelihoodField::distances(const ScanPoints& points,
                                               const SE2& T_map_base) const {
  const GridFrame& frame = distances_.frame();
  const PoseInCells pose(frame, T_map_base);
  std::vector<double> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p_cells(pose.x(points.x[i], points.y[i]),
                                  pose.y(points.x[i], points.y[i]));
    result[i] = distances_.at(p_cells * frame.resolution);
  }
  return result;
}

double LikelihoodField::beam_probability(double distance, double range_max) const {
  const double z = distance / config_.sigma_hit;
  return config_.z_hit * std::exp(-0.5 * z * z) + config_.z_rand / range_max;
}

double LikelihoodField::quality(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  const PoseInCells pose(distances_.frame(), T_map_base);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += static_cast<double>(
        gaussian_at(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i])));
  }
  return sum / static_cast<double>(points.size());
}

}  // namespace castaway::localization
