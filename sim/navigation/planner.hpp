/// Shortest safe paths on a grid.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"

namespace castaway::sim {

/// What a path costs.
struct PlannerConfig {
  double comfort = 0.4;         ///< [m] Wanted room beyond the robot's own radius.
  double comfort_weight = 3.0;  ///< Cost of a metre right at the obstacle, over a metre far off.
};

/// Plans with A* over the 8-connected free cells; never cuts a corner. From the free cell nearest
/// to `start` to the one nearest to `goal`: points of map a cell apart. Nothing if there is no way.
std::optional<std::vector<Eigen::Vector2d>> plan_path(const FreeSpace& free,
                                                      const Eigen::Vector2d& start,
                                                      const Eigen::Vector2d& goal,
                                                      const PlannerConfig& config = {});

}  // namespace castaway::sim
