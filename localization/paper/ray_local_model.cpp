#include "localization/paper/ray_local_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/map/cell_index.hpp"
#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {

RayLocalModel::RayLocalModel(const RayLocalConfig& config, const OccupancyGrid& grid)
    : frame_(grid.frame) {
  validate(grid);
  if (!(config.sigma > 0.0)) throw std::invalid_argument("sigma must be positive");
  for (const CellState cell : grid.cells) {
    occupied_.push_back(cell == CellState::kOccupied ? 1 : 0);
  }
  const auto probes = cell_index(3.0 * config.sigma / frame_.resolution + 1e-9);
  for (int k = 0; k <= probes; ++k) {
    const double z = k * frame_.resolution / config.sigma;
    log_likelihood_.push_back(-0.5 * z * z);
    hit_.push_back(std::min(1.0, config.hit_peak * std::exp(-0.5 * z * z)));
  }
  log_likelihood_.push_back(-4.5);
  hit_.push_back(0.0);
}

bool RayLocalModel::is_occupied(float x_cells, float y_cells) const {
  const Eigen::Vector2i cell(cell_index(x_cells), cell_index(y_cells));
  return frame_.contains(cell) && occupied_[frame_.index(cell)] != 0;
}

RayLocalScore RayLocalModel::evaluate(const ScanPoints& points, const SE2& T_map_base) const {
  const PoseInCells pose(frame_, T_map_base);
  const std::size_t none = log_likelihood_.size() - 1;
  RayLocalScore score;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = pose.x(points.x[i], points.y[i]);
    const float y = pose.y(points.x[i], points.y[i]);
    const float dx = x - pose.x(points.origin_x[i], points.origin_y[i]);
    const float dy = y - pose.y(points.origin_x[i], points.origin_y[i]);
    const float length = std::max(std::hypot(dx, dy), 1e-6F);
    std::size_t k = 0;
    for (; k < none; ++k) {
      const float t = static_cast<float>(k) / length;
      if (is_occupied(x + t * dx, y + t * dy) || is_occupied(x - t * dx, y - t * dy)) break;
    }
    score.log_likelihood += log_likelihood_[k];
    score.hits += hit_[k];
  }
  return score;
}

}  // namespace castaway::localization
