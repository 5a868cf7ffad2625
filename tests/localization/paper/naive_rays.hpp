/// The paper's observation model and cascade as plain loops, for tests of the fast ones.
#pragma once

#include <algorithm>
#include <cmath>

#include "localization/map/cell_index.hpp"
#include "localization/map/coarsen.hpp"
#include "localization/paper/paper_cascade.hpp"
#include "tests/localization/matching/search_case.hpp"

namespace castaway::test {

using namespace localization;  // test support of one library

inline bool is_wall(const OccupancyGrid& grid, float x_cells, float y_cells) {
  const Eigen::Vector2i cell(cell_index(x_cells), cell_index(y_cells));
  return grid.frame.contains(cell) && grid.cells[grid.frame.index(cell)] == CellState::kOccupied;
}

/// A random room, turned and moved in map.
inline OccupancyGrid turned_room(Rng& rng) {
  OccupancyGrid grid = random_room(rng);
  grid.frame.T_map_grid = {uniform(-9, 9, rng), uniform(-9, 9, rng), uniform(-3, 3, rng)};
  return grid;
}

/// Probes every beam cell by cell, both ways.
inline RayLocalScore naive_ray_score(const RayLocalConfig& config, const OccupancyGrid& grid,
                                     const ScanPoints& points, const SE2& T_map_base) {
  const PoseInCells pose(grid.frame, T_map_base);
  const int none = cell_index(3.0 * config.sigma / grid.frame.resolution + 1e-9) + 1;
  RayLocalScore score;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = pose.x(points.x[i], points.y[i]);
    const float y = pose.y(points.x[i], points.y[i]);
    const float dx = x - pose.x(points.origin_x[i], points.origin_y[i]);
    const float dy = y - pose.y(points.origin_x[i], points.origin_y[i]);
    const float length = std::max(std::hypot(dx, dy), 1e-6F);
    int k = 0;
    for (; k < none; ++k) {
      const float t = static_cast<float>(k) / length;
      if (is_wall(grid, x + t * dx, y + t * dy) || is_wall(grid, x - t * dx, y - t * dy)) break;
    }
    const double z = k * grid.frame.resolution / config.sigma;
    score.log_likelihood += k < none ? -0.5 * z * z : -4.5;
    score.hits += k < none ? std::min(1.0, config.hit_peak * std::exp(-0.5 * z * z)) : 0.0;
  }
  return score;
}

/// A place of the cascade.
struct NaiveNode {
  Eigen::Vector2i cell;
  SE2 T_map_base;
  double yaw = 0.0;  ///< [rad] In the grid's frame.
  double quality = 0.0;
};

/// The nodes on cells with free space that reach the threshold, best first.
inline std::vector<NaiveNode> best_nodes(const PaperCascadeConfig& config, double sigma, int level,
                                         const OccupancyGrid& map, const ScanPoints& points,
                                         const std::vector<NaiveNode>& nodes) {
  const OccupancyGrid grid = coarsen(map, 1 << level);
  const RayLocalConfig sensor{std::max(sigma, 0.5 * grid.frame.resolution)};
  std::vector<NaiveNode> best;
  for (NaiveNode node : nodes) {
    if (!grid.frame.contains(node.cell)) continue;
    const CellState state = grid.cells[grid.frame.index(node.cell)];
    if (state == CellState::kUnknown) continue;
    if (state == CellState::kOccupied && level == config.finest_level) continue;
    const Eigen::Vector2d p = grid.frame.centre_of(node.cell);
    node.T_map_base = grid.frame.T_map_grid * SE2{p.x(), p.y(), wrap_angle(node.yaw)};
    node.quality = naive_ray_score(sensor, grid, points, node.T_map_base).hits /
                   static_cast<double>(points.size());
    if (node.quality >= config.threshold) best.push_back(node);
  }
  std::stable_sort(best.begin(), best.end(),
                   [](const NaiveNode& a, const NaiveNode& b) { return a.quality > b.quality; });
  best.resize(std::min(best.size(), static_cast<std::size_t>(config.max_per_level)));
  return best;
}

/// Evaluates every node of the coarsest level, and every child of the best ones.
inline std::vector<NaiveNode> naive_cascade(const PaperCascadeConfig& config, double sigma,
                                            const OccupancyGrid& map, const ScanPoints& points) {
  const GridFrame frame = coarsen(map, 1 << (config.levels - 1)).frame;
  const long yaws = std::lround(2.0 * std::numbers::pi / config.yaw_step);
  std::vector<NaiveNode> nodes;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      for (int yaw = 0; yaw < yaws; ++yaw) {
        const double angle = 2.0 * std::numbers::pi * yaw / static_cast<double>(yaws);
        nodes.push_back({{column, row}, {}, angle});
      }
    }
  }
  nodes = best_nodes(config, sigma, config.levels - 1, map, points, nodes);
  for (int level = config.levels - 2; level >= config.finest_level; --level) {
    std::vector<NaiveNode> children;
    for (const NaiveNode& node : nodes) {
      for (int k = 0; k < 4; ++k) {
        children.push_back({2 * node.cell + Eigen::Vector2i(k % 2, k / 2), {}, node.yaw});
      }
    }
    nodes = best_nodes(config, sigma, level, map, points, children);
  }
  return nodes;
}

/// The nodes that are not close to a better one.
inline std::vector<Candidate> distinct(const PaperCascadeConfig& config,
                                       const std::vector<NaiveNode>& nodes) {
  std::vector<Candidate> candidates;
  for (const NaiveNode& node : nodes) {
    const bool near = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return distance(c.T_map_base, node.T_map_base) < config.apart_m &&
             yaw_distance(c.T_map_base, node.T_map_base) < 1.5 * config.yaw_step;
    });
    if (!near) candidates.push_back({node.T_map_base, node.quality});
  }
  return candidates;
}

}  // namespace castaway::test
