/// Drives towards a point around obstacles that the lidars see.
///
/// D. Fox, W. Burgard, S. Thrun, "The Dynamic Window Approach to Collision Avoidance", IEEE
/// Robotics & Automation Magazine 4(1), 1997. We roll each velocity out over a horizon in which the
/// robot can stop, and rate it by its end pose and by its least distance to obstacles. Unlike the
/// paper, we predict where moving obstacles will be at each step of the roll-out.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/navigation/movers.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"

namespace castaway::sim {

/// Parameters of the velocity search.
struct DynamicWindowConfig {
  TwistLimits limits;
  double radius = 0.25;  ///< [m] Of the robot's disc about base.
  double margin = 0.04;  ///< [m] Least room to obstacles; velocities with less are rejected.
  double comfort = 0.2;  ///< [m] Wanted room to obstacles; less of it costs.
  double horizon = 1.6;  ///< [s] Length of a roll-out; longer than the robot takes to stop.
  double window = 0.4;   ///< [s] A velocity must be reachable within this time.
  int speeds = 6;        ///< Forward speeds tried.
  int turns = 15;        ///< Turn rates tried with each forward speed.
};

/// Returns the best velocity towards `p_base_target`, starting from the velocity `current`.
/// `p_base` are the static obstacles [m] and `movers` the moving ones, all in base at the current
/// time; movers are extrapolated with their velocities along the roll-out. Returns nothing if no
/// velocity is safe, or none is better than standing still.
std::optional<Twist2> best_twist(const DynamicWindowConfig& config, const Twist2& current,
                                 const Eigen::Vector2d& p_base_target,
                                 const std::vector<Eigen::Vector2d>& p_base,
                                 const std::vector<Mover>& movers = {});

}  // namespace castaway::sim
