/// Drives towards a point around what the lidar sees.
///
/// D. Fox, W. Burgard, S. Thrun, "The Dynamic Window Approach to Collision Avoidance", IEEE
/// Robotics & Automation Magazine 4(1), 1997. We roll each velocity out over a horizon in which the
/// robot can stop, and rate it by where it ends and how near it comes to anything. Beyond the
/// paper: what moves is met where it will be.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/navigation/movers.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"

namespace castaway::sim {

/// How velocities are chosen.
struct DynamicWindowConfig {
  TwistLimits limits;
  double radius = 0.25;  ///< [m] Of the robot, about base.
  double margin = 0.04;  ///< [m] Kept free around it, whatever else.
  double comfort = 0.2;  ///< [m] Wished for.
  double horizon = 1.6;  ///< [s] Rolled out; longer than the robot takes to stop.
  double window = 0.4;   ///< [s] In which a velocity must be reachable.
  int speeds = 6;        ///< Forward speeds tried.
  int turns = 15;        ///< Turn rates tried with each.
};

/// The best velocity towards `p_base_target` among `p_base` obstacles [m], all in base, from
/// `current` on. `movers`, in base as it is now, are where they will be at each time of the
/// roll-out. Nothing where none is safe, or none better than standing still.
std::optional<Twist2> best_twist(const DynamicWindowConfig& config, const Twist2& current,
                                 const Eigen::Vector2d& p_base_target,
                                 const std::vector<Eigen::Vector2d>& p_base,
                                 const std::vector<Mover>& movers = {});

}  // namespace castaway::sim
