/// What each person is about to do. Internal to sim/people.
#pragma once

#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/robot_body.hpp"

namespace castaway::sim {

/// Wanted velocity and heading.
struct Intent {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double heading = 0.0;                                ///< [rad]
  double top_speed = 0.0;                              ///< [m/s] Whatever forces push.
  bool minds_robot = true;                             ///< False: it keeps no distance by force.
};

/// What a person wants at time `now` [s]: its place in the crowd, its reaction to the robot, its
/// way to the next place (followers: abreast of the leader, 0.65 m apart), or its rest. May draw
/// the next place and the rest there from the person's stream.
Intent intend(std::size_t index, std::vector<Agent>& agents, GoalFields& goals,
              const RobotBody& robot, double now);

/// Counts for how long a walker has wanted to walk and could not; then it will go elsewhere.
void note_progress(const Intent& intent, double dt, Agent& agent);

}  // namespace castaway::sim
