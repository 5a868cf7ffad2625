#include "localization/paper/paper_cascade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "localization/map/coarsen.hpp"

namespace castaway::localization {

PaperCascade::PaperCascade(const PaperCascadeConfig& config, const RayLocalConfig& sensor,
                           const OccupancyGrid& grid, const CellFilter& is_searched)
    : config_(config),
      yaws_(std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / config_.yaw_step)))) {
  for (int level = config.finest_level; level < config.levels; ++level) {
    OccupancyGrid coarse = coarsen(grid, 1 << level);
    const double sigma = std::max(sensor.sigma, 0.5 * coarse.frame.resolution);
    RayLocalModel model({sigma}, coarse);
    HitBounds bounds(model);
    levels_.push_back({std::move(coarse), std::move(model), std::move(bounds)});
  }
  if (!levels_.empty()) runs_ = searched_runs(is_searched);
}

/// True if base may be in a cell.
bool PaperCascade::is_possible(std::size_t level, const Eigen::Vector2i& cell) const {
  const OccupancyGrid& grid = levels_[level].grid;
  if (!grid.frame.contains(cell)) return false;
  const CellState state = grid.cells[grid.frame.index(cell)];
  // A coarse cell with a wall may also contain free cells.
  return state == CellState::kFree || (level > 0 && state == CellState::kOccupied);
}

std::vector<CellRun> PaperCascade::searched_runs(const CellFilter& is_searched) const {
  const GridFrame& frame = levels_.back().grid.frame;
  std::vector<CellRun> runs;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      if (!is_possible(levels_.size() - 1, {column, row})) continue;
      if (is_searched && !is_searched(frame, column, row)) continue;
      const bool joins = !runs.empty() && runs.back().row == row && runs.back().end == column;
      if (!joins) runs.push_back({row, column, column});
      runs.back().end = column + 1;
    }
  }
  return runs;
}

std::vector<RaysAtYaw> PaperCascade::rays_by_yaw(const Level& level,
                                                 const ScanPoints& points) const {
  std::vector<RaysAtYaw> rays;
  for (std::size_t yaw = 0; yaw < static_cast<std::size_t>(yaws_); ++yaw) {
    rays.emplace_back(level.model, points, yaw_of(level, yaw));
  }
  return rays;
}

/// The nodes of the coarsest level whose bound reaches the threshold, by row, column and yaw.
std::vector<PaperCascade::Node> PaperCascade::likely_nodes(const std::vector<RaysAtYaw>& rays,
                                                           std::size_t beams) const {
  const HitBounds& bounds = levels_.back().bounds;
  const std::int64_t least = bounds.least(config_.threshold, beams);
  std::vector<std::vector<std::uint32_t>> sums(rays.size());
  std::vector<Node> nodes;
  for (const CellRun& run : runs_) {
    for (std::size_t yaw = 0; yaw < rays.size(); ++yaw) {
      sums[yaw] = bounds.in_run(rays[yaw].ends(), run);
    }
    for (int column = run.first; column < run.end; ++column) {
      for (std::size_t yaw = 0; yaw < rays.size(); ++yaw) {
        const std::int64_t bound = sums[yaw][static_cast<std::size_t>(column - run.first)];
        if (bound >= least) nodes.push_back({{column, run.row}, yaw, bound});
      }
    }
  }
  return nodes;
}

/// The nodes of a level within those of the level above whose bound reaches the threshold.
std::vector<PaperCascade::Node> PaperCascade::likely_children(const std::vector<Node>& nodes,
                                                              std::size_t level,
                                                              const std::vector<RaysAtYaw>& rays,
                                                              std::size_t beams) const {
  const HitBounds& bounds = levels_[level].bounds;
  const std::int64_t least = bounds.least(config_.threshold, beams);
  std::vector<Node> fine;
  for (const Node& node : nodes) {
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector2i cell = 2 * node.cell + Eigen::Vector2i(k % 2, k / 2);
      if (!is_possible(level, cell)) continue;
      const std::int64_t bound = bounds.at(rays[node.yaw].ends(), cell);
      if (bound >= least) fine.push_back({cell, node.yaw, bound});
    }
  }
  return fine;
}

/// Yaw of base in map. [rad]
double PaperCascade::yaw_of(const Level& level, std::size_t yaw) const {
  const double yaw_grid = 2.0 * std::numbers::pi * static_cast<double>(yaw) / yaws_;
  return wrap_angle(level.grid.frame.T_map_grid.yaw + wrap_angle(yaw_grid));
}

SE2 PaperCascade::pose_of(const Level& level, const Node& node) const {
  const GridFrame& frame = level.grid.frame;
  const Eigen::Vector2d p = frame.T_map_grid * frame.centre_of(node.cell);
  return {p.x(), p.y(), yaw_of(level, node.yaw)};
}

/// Evaluates the `max_per_level` nodes with the highest bounds, and returns their least quality.
/// Requires as many nodes.
double PaperCascade::least_of_strongest(std::vector<Node>& nodes,
                                        const std::vector<RaysAtYaw>& rays,
                                        std::size_t beams) const {
  std::vector<Node*> strongest;
  for (Node& node : nodes) strongest.push_back(&node);
  std::nth_element(strongest.begin(), strongest.begin() + config_.max_per_level - 1,
                   strongest.end(),
                   [](const Node* a, const Node* b) { return a->bound > b->bound; });
  strongest.resize(static_cast<std::size_t>(config_.max_per_level));
  double least = std::numeric_limits<double>::infinity();
  for (Node* node : strongest) {
    node->quality = rays[node->yaw].hits(node->cell) / static_cast<double>(beams);
    least = std::min(least, node->quality);
  }
  return least;
}

/// The nodes whose quality reaches the threshold, best first.
std::vector<PaperCascade::Node> PaperCascade::score_nodes(const Level& level,
                                                          std::vector<Node> nodes,
                                                          const std::vector<RaysAtYaw>& rays,
                                                          std::size_t beams) const {
  const auto most = static_cast<std::size_t>(config_.max_per_level);
  std::int64_t least = std::numeric_limits<std::int64_t>::min();
  if (nodes.size() > most) {
    least = level.bounds.least(least_of_strongest(nodes, rays, beams), beams);
  }
  std::erase_if(nodes, [&](Node& node) {
    if (node.bound < least) return true;
    if (node.quality < 0.0) {
      node.quality = rays[node.yaw].hits(node.cell) / static_cast<double>(beams);
    }
    return node.quality < config_.threshold;
  });
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const Node& a, const Node& b) { return a.quality > b.quality; });
  if (nodes.size() > most) nodes.erase(nodes.begin() + config_.max_per_level, nodes.end());
  return nodes;
}

/// The nodes of the finest level, best first.
std::vector<PaperCascade::Node> PaperCascade::best_nodes(const ScanPoints& points) const {
  std::vector<RaysAtYaw> rays = rays_by_yaw(levels_.back(), points);
  std::vector<Node> nodes =
      score_nodes(levels_.back(), likely_nodes(rays, points.size()), rays, points.size());
  for (std::size_t level = levels_.size() - 1; level-- > 0;) {
    rays = rays_by_yaw(levels_[level], points);
    nodes = likely_children(nodes, level, rays, points.size());
    nodes = score_nodes(levels_[level], std::move(nodes), rays, points.size());
  }
  return nodes;
}

std::vector<Candidate> PaperCascade::match(const ScanPoints& points) const {
  if (points.empty() || levels_.empty()) return {};
  std::vector<Candidate> candidates;
  for (const Node& node : best_nodes(points)) {
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
