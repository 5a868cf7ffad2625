#include "localization/paper/paper_cascade.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "localization/map/coarsen.hpp"

namespace castaway::localization {

PaperCascade::PaperCascade(const PaperCascadeConfig& config, const RayLocalConfig& sensor,
                           const OccupancyGrid& grid, CellFilter is_searched)
    : config_(config),
      is_searched_(std::move(is_searched)),
      yaws_(std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / config_.yaw_step)))) {
  for (int level = config.finest_level; level < config.levels; ++level) {
    OccupancyGrid coarse = coarsen(grid, 1 << level);
    const double sigma = std::max(sensor.sigma, 0.5 * coarse.frame.resolution);
    RayLocalModel model({sigma}, coarse);
    levels_.push_back({std::move(coarse), std::move(model)});
  }
}

std::vector<PaperCascade::Node> PaperCascade::all_nodes() const {
  const OccupancyGrid& grid = levels_.back().grid;
  std::vector<Node> nodes;
  for (int row = 0; row < grid.frame.height; ++row) {
    for (int column = 0; column < grid.frame.width; ++column) {
      if (is_searched_ && !is_searched_(grid.frame, column, row)) continue;
      for (int yaw = 0; yaw < yaws_; ++yaw) nodes.push_back({{column, row}, yaw, 0.0});
    }
  }
  return nodes;
}

std::vector<PaperCascade::Node> PaperCascade::children(const std::vector<Node>& nodes) const {
  std::vector<Node> fine;
  for (const Node& node : nodes) {
    for (int k = 0; k < 4; ++k) {
      fine.push_back({2 * node.cell + Eigen::Vector2i(k % 2, k / 2), node.yaw, 0.0});
    }
  }
  return fine;
}

SE2 PaperCascade::pose_of(const Level& level, const Node& node) const {
  const Eigen::Vector2d p = level.grid.frame.centre_of(node.cell);
  const SE2 T_grid_base{p.x(), p.y(), wrap_angle(2.0 * std::numbers::pi * node.yaw / yaws_)};
  return level.grid.frame.T_map_grid * T_grid_base;
}

/// The nodes on cells with free space whose quality reaches the threshold, best first.
std::vector<PaperCascade::Node> PaperCascade::score_nodes(const Level& level,
                                                          std::vector<Node> nodes,
                                                          const ScanPoints& points) const {
  const bool coarse = &level != &levels_.front();
  std::erase_if(nodes, [&](Node& node) {
    if (!level.grid.frame.contains(node.cell)) return true;
    const CellState state = level.grid.cells[level.grid.frame.index(node.cell)];
    // A coarse cell with a wall may also contain free cells.
    if (state == CellState::kUnknown || (!coarse && state == CellState::kOccupied)) return true;
    node.quality = level.model.evaluate(points, pose_of(level, node)).hits /
                   static_cast<double>(points.size());
    return node.quality < config_.threshold;
  });
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const Node& a, const Node& b) { return a.quality > b.quality; });
  const auto most = static_cast<std::size_t>(config_.max_per_level);
  if (nodes.size() > most) nodes.erase(nodes.begin() + config_.max_per_level, nodes.end());
  return nodes;
}

std::vector<Candidate> PaperCascade::match(const ScanPoints& points) const {
  if (points.empty()) return {};
  std::vector<Node> nodes = score_nodes(levels_.back(), all_nodes(), points);
  for (std::size_t level = levels_.size() - 1; level-- > 0;) {
    nodes = score_nodes(levels_[level], children(nodes), points);
  }
  std::vector<Candidate> candidates;
  for (const Node& node : nodes) {
    const SE2 pose = pose_of(levels_.front(), node);
    const bool near = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return distance(c.T_map_base, pose) < config_.apart_m &&
             yaw_distance(c.T_map_base, pose) < 1.5 * config_.yaw_step;
    });
    if (!near) candidates.push_back({pose, node.quality});
  }
  return candidates;
}

}  // namespace castaway::localization
