/// Shortest safe paths on a grid.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"

namespace castaway::sim {

/// Parameters of a path's cost.
struct PlannerConfig {
  double comfort = 0.4;  ///< [m] Wanted room beyond the disc's radius.
  /// Extra cost of a metre right beside an obstacle; a metre in the open costs 1.
  double comfort_weight = 3.0;
};

/// Price of a metre in a cell of `free.grid()`: 1 or more.
double path_price(const FreeSpace& free, std::size_t cell, const PlannerConfig& config);

/// Plans with A* over the 8-connected free cells, never cutting a corner, from the free cell
/// nearest to `start` to the one nearest to `goal`. Returns points in map one cell apart; nothing
/// if there is no path. On levels as `plan_on_levels`.
std::optional<std::vector<Eigen::Vector2d>> plan_path(const FreeSpace& free,
                                                      const Eigen::Vector2d& start,
                                                      const Eigen::Vector2d& goal,
                                                      const PlannerConfig& config = {});

}  // namespace castaway::sim
