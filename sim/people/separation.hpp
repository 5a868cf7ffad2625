/// Hard limits on people's positions: walls, the robot, other people.
#pragma once

#include <optional>
#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Returns where a body ends up that moves from `from` by `way` [m], at most `WalkSpace::kMaxStep`:
/// it slides along a wall in the way, or stays. `from` must be free; so is the result.
Eigen::Vector2d slide_along_walls(const WalkSpace& space, const Eigen::Vector2d& from,
                                  const Eigen::Vector2d& way);

/// Pushes people who overlap each other or the robot apart, as far as walls allow, to at most
/// `WalkSpace::kMaxStep` from their states `before`. People step back from a robot that comes
/// nearer than 8 cm, at no more than 0.4 m/s.
void separate(const WalkSpace& space, const RobotBody& robot,
              const std::vector<PersonState>& before, std::vector<Agent>& agents);

/// Moves feet that are in or near the robot away from it: nobody steps onto it or is run over.
void keep_feet_off(const RobotBody& robot, PersonState& state);

/// True if a person is so close to a robot that was just put down that it must step aside.
bool stands_close(const RobotBody& robot, const Agent& agent);
/// Returns where the person steps to: the first free place that can be reached in a straight line,
/// on the nearest ring and with the least turn from straight away; nothing if there is none.
std::optional<Eigen::Vector2d> place_aside(const WalkSpace& space, const RobotBody& robot,
                                           const Agent& agent);

}  // namespace castaway::sim
