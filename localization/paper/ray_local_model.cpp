#include "localization/paper/ray_local_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {

namespace {

/// Number of the last probe in each direction.
int last_probe(const RayLocalConfig& config, const OccupancyGrid& grid) {
  validate(grid);
  if (!(config.sigma > 0.0)) throw std::invalid_argument("sigma must be positive");
  return cell_index(3.0 * config.sigma / grid.frame.resolution + 1e-9);
}

}  // namespace

RayLocalModel::RayLocalModel(const RayLocalConfig& config, const OccupancyGrid& grid)
    : frame_(grid.frame), walls_(grid, std::min(last_probe(config, grid) + 2, 255)) {
  for (int k = 0; k <= last_probe(config, grid); ++k) {
    const double z = k * frame_.resolution / config.sigma;
    log_likelihood_.push_back(-0.5 * z * z);
    hit_.push_back(std::min(1.0, config.hit_peak * std::exp(-0.5 * z * z)));
  }
  log_likelihood_.push_back(-4.5);
  hit_.push_back(0.0);
}

bool RayLocalModel::is_occupied(float x_cells, float y_cells) const {
  return walls_.at(cell_index(x_cells), cell_index(y_cells)) == 0;
}

std::size_t RayLocalModel::error_cells(const ScanPoints& points, std::size_t beam,
                                       const PoseInCells& pose) const {
  const float x = pose.x(points.x[beam], points.y[beam]);
  const float y = pose.y(points.x[beam], points.y[beam]);
  const int nearest = walls_.at(cell_index(x), cell_index(y));
  if (nearest == 0) return 0;
  const std::size_t none = no_wall();
  // Probe k lies at most k + 1 columns and rows away.
  auto k = static_cast<std::size_t>(std::max(nearest - 1, 1));
  if (k >= none) return none;
  const float dx = x - pose.x(points.origin_x[beam], points.origin_y[beam]);
  const float dy = y - pose.y(points.origin_x[beam], points.origin_y[beam]);
  // As `std::hypot` of floats, whose squares are exact in double.
  const double squared = static_cast<double>(dx) * dx + static_cast<double>(dy) * dy;
  const float length = std::max(static_cast<float>(std::sqrt(squared)), 1e-6F);
  for (; k < none; ++k) {
    const float t = static_cast<float>(k) / length;
    if (is_occupied(x + t * dx, y + t * dy) || is_occupied(x - t * dx, y - t * dy)) break;
  }
  return k;
}

RayLocalScore RayLocalModel::evaluate(const ScanPoints& points, const SE2& T_map_base) const {
  const PoseInCells pose(frame_, T_map_base);
  RayLocalScore score;
  for (std::size_t beam = 0; beam < points.size(); ++beam) {
    const std::size_t k = error_cells(points, beam, pose);
    score.log_likelihood += log_likelihood_[k];
    score.hits += hit_[k];
  }
  return score;
}

}  // namespace castaway::localization
