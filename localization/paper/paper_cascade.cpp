#include "localization/paper/paper_cascade.hpp"

#include <algorithm>
#include <cmath>
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
  runs_ = searched_runs(is_searched);
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

std::vector<std::vector<CellOffset>> PaperCascade::ends_by_yaw(const Level& level,
                                                               const ScanPoints& points) const {
  std::vector<std::vector<CellOffset>> ends;
  for (int yaw = 0; yaw < yaws_; ++yaw) {
    ends.push_back(end_cells(level.model, points, yaw_of(level, yaw)));
  }
  return ends;
}

/// The nodes of the coarsest level whose bound reaches the threshold, by row, column and yaw.
std::vector<PaperCascade::Node> PaperCascade::likely_nodes(const ScanPoints& points) const {
  const Level& level = levels_.back();
  const std::int64_t least = level.bounds.least(config_.threshold, points.size());
  const auto ends = ends_by_yaw(level, points);
  std::vector<std::vector<std::uint32_t>> bounds(ends.size());
  std::vector<Node> nodes;
  for (const CellRun& run : runs_) {
    for (std::size_t yaw = 0; yaw < ends.size(); ++yaw) {
      bounds[yaw] = level.bounds.in_run(ends[yaw], run);
    }
    for (int column = run.first; column < run.end; ++column) {
      for (int yaw = 0; yaw < yaws_; ++yaw) {
        const auto i = static_cast<std::size_t>(column - run.first);
        const std::int64_t bound = bounds[static_cast<std::size_t>(yaw)][i];
        if (bound >= least) nodes.push_back({{column, run.row}, yaw, 0.0});
      }
    }
  }
  return nodes;
}

/// The nodes of a level within those of the level above whose bound reaches the threshold.
std::vector<PaperCascade::Node> PaperCascade::likely_children(const std::vector<Node>& nodes,
                                                              std::size_t level,
                                                              const ScanPoints& points) const {
  const HitBounds& bounds = levels_[level].bounds;
  const std::int64_t least = bounds.least(config_.threshold, points.size());
  const auto ends = ends_by_yaw(levels_[level], points);
  std::vector<Node> fine;
  for (const Node& node : nodes) {
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector2i cell = 2 * node.cell + Eigen::Vector2i(k % 2, k / 2);
      if (!is_possible(level, cell)) continue;
      const std::int64_t bound = bounds.at(ends[static_cast<std::size_t>(node.yaw)], cell);
      if (bound >= least) fine.push_back({cell, node.yaw, 0.0});
    }
  }
  return fine;
}

/// Yaw of base in map. [rad]
double PaperCascade::yaw_of(const Level& level, int yaw) const {
  return wrap_angle(level.grid.frame.T_map_grid.yaw +
                    wrap_angle(2.0 * std::numbers::pi * yaw / yaws_));
}

SE2 PaperCascade::pose_of(const Level& level, const Node& node) const {
  const Eigen::Vector2d p = level.grid.frame.T_map_grid * level.grid.frame.centre_of(node.cell);
  return {p.x(), p.y(), yaw_of(level, node.yaw)};
}

/// The nodes whose quality reaches the threshold, best first.
std::vector<PaperCascade::Node> PaperCascade::score_nodes(const Level& level,
                                                          std::vector<Node> nodes,
                                                          const ScanPoints& points) const {
  std::erase_if(nodes, [&](Node& node) {
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
  std::vector<Node> nodes = score_nodes(levels_.back(), likely_nodes(points), points);
  for (std::size_t level = levels_.size() - 1; level-- > 0;) {
    nodes = score_nodes(levels_[level], likely_children(nodes, level, points), points);
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
