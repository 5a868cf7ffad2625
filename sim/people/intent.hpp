/// What each person wants to do next. Internal to sim/people.
#pragma once

#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/robot_body.hpp"

namespace castaway::sim {

/// Wanted velocity and heading of a person.
struct Intent {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double heading = 0.0;                                ///< [rad]
  double top_speed = 0.0;    ///< [m/s] Speed limit, whatever the forces are.
  bool avoids_robot = true;  ///< False: the robot exerts no force on it.
};

/// Returns what a person wants at time `now` [s]: its place in the crowd, its reaction to the
/// robot, its way to the next place (followers: abreast of the leader, 0.65 m apart), or its rest.
/// May draw the next place and the rest there from the person's stream.
Intent intend(std::size_t index, std::vector<Agent>& agents, GoalFields& goals,
              const RobotBody& robot, double now);

/// Updates for how long a walker has wanted to walk without headway; if for too long, it picks
/// another goal.
void note_progress(const Intent& intent, double dt, Agent& agent);

}  // namespace castaway::sim
