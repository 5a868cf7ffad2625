#include "tools/batch/bench/plain_match.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace castaway::testbed {
namespace {

using namespace localization;

/// Likelihoods of coarse cells, looked up in metres; 0 outside the map.
struct PlainField {
  GridFrame frame;
  std::vector<double> likelihood;
  std::vector<bool> is_free;

  PlainField(const MatcherConfig& config, const OccupancyGrid& grid,
             const DistanceField& distances) {
    const GridFrame& fine = grid.frame;
    const auto factor = std::lround(config.field.resolution / fine.resolution);
    const int f = std::max(1, static_cast<int>(factor));
    frame = {(fine.width + f - 1) / f, (fine.height + f - 1) / f, f * fine.resolution,
             fine.T_map_grid};
    likelihood.assign(frame.size(), 0.0);
    is_free.assign(frame.size(), false);
    for (int row = 0; row < fine.height; ++row) {
      for (int column = 0; column < fine.width; ++column) {
        const std::size_t i = fine.index({column, row});
        const std::size_t coarse = frame.index({column / f, row / f});
        const double z = static_cast<double>(distances.values()[i]) / config.field.sigma;
        likelihood[coarse] = std::max(likelihood[coarse], std::exp(-0.5 * z * z));
        if (grid.cells[i] == CellState::kFree) is_free[coarse] = true;
      }
    }
  }
  [[nodiscard]] double at(const Eigen::Vector2d& p_grid) const {
    const Eigen::Vector2i cell = frame.cell_of(p_grid);
    return frame.contains(cell) ? likelihood[frame.index(cell)] : 0.0;
  }
};

/// At most `count` end points [m], evenly spaced over the scan, rotated by `yaw`.
std::vector<Eigen::Vector2d> rotated_points(const PlainScan& scan, int count, double yaw) {
  const std::size_t used = std::min(scan.range.size(), static_cast<std::size_t>(count));
  std::vector<Eigen::Vector2d> points;
  for (std::size_t k = 0; k < used; ++k) {
    const std::size_t i = k * scan.range.size() / used;
    const double heading = yaw + scan.angle[i];
    points.emplace_back(scan.range[i] * std::cos(heading), scan.range[i] * std::sin(heading));
  }
  return points;
}

/// The best free cell for the rotated end points.
Candidate best_cell(const PlainField& field, const std::vector<Eigen::Vector2d>& points) {
  Candidate best;
  for (int row = 0; row < field.frame.height; ++row) {
    for (int column = 0; column < field.frame.width; ++column) {
      if (!field.is_free[field.frame.index({column, row})]) continue;
      const Eigen::Vector2d base = field.frame.centre_of({column, row});
      double sum = 0.0;
      for (const Eigen::Vector2d& p : points) sum += field.at(base + p);
      const double score = sum / static_cast<double>(points.size());
      if (score > best.score) best = {{base.x(), base.y(), 0.0}, score};
    }
  }
  return best;
}

}  // namespace

Candidate plain_match(const MatcherConfig& config, const OccupancyGrid& grid,
                      const DistanceField& distances, const PlainScan& scan) {
  const PlainField field(config, grid, distances);
  const auto yaws = std::lround(2.0 * std::numbers::pi / config.yaw_step);
  Candidate best;
  for (int k = 0; k < yaws; ++k) {
    const double yaw = 2.0 * std::numbers::pi * k / static_cast<double>(yaws);
    Candidate found = best_cell(field, rotated_points(scan, config.points, yaw));
    found.T_map_base.yaw = wrap_angle(yaw);
    if (found.score > best.score) best = found;
  }
  best.T_map_base = field.frame.T_map_grid * best.T_map_base;
  return best;
}

}  // namespace castaway::testbed
