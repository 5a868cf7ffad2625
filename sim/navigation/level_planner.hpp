/// Shortest safe paths over several floors.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/map/free_space.hpp"
#include "sim/navigation/planner.hpp"

namespace castaway::sim {

/// As `plan_path`, in a free space on levels (`FreeSpace::levels`), in frame plane. A path that
/// leaves the chart of its start ends 1 m behind it, in the frame of that chart: by then the
/// robot's pose is in the next one.
std::optional<std::vector<Eigen::Vector2d>> plan_on_levels(const FreeSpace& free,
                                                           const Eigen::Vector2d& start,
                                                           const Eigen::Vector2d& goal,
                                                           const PlannerConfig& config);

/// The whole path in map. [m]
std::optional<std::vector<Eigen::Vector3d>> plan_over_levels(const FreeSpace& free,
                                                             const Eigen::Vector2d& start,
                                                             const Eigen::Vector2d& goal,
                                                             const PlannerConfig& config);

}  // namespace castaway::sim
