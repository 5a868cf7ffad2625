/// Hard limits on where people go: no wall, no robot, nobody else.
#pragma once

#include <optional>
#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// Where a body ends up that wants to go from `from` by `way` [m], at most `WalkSpace::kMaxStep`:
/// along the wall where it may not go straight on, or nowhere. `from` must be clear; so is the
/// result.
Eigen::Vector2d moved(const WalkSpace& space, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& way);

/// Pushes people who stand in each other, or in the robot, apart, as far as walls let them; at most
/// `WalkSpace::kMaxStep` from where each was `before`. People step back from a robot that
/// comes nearer than 8 cm, at 0.4 m/s at most.
void separate(const WalkSpace& space, const RobotBody& robot,
              const std::vector<PersonState>& before, std::vector<Agent>& agents);

/// Draws feet back that are in the robot or nearly: nobody steps onto it, or lets it drive over
/// them.
void keep_feet_off(const RobotBody& robot, PersonState& state);

/// True if a robot that was just put down is so near to somebody that they step aside.
bool stands_close(const RobotBody& robot, const Agent& agent);
/// Where they step to: off the robot by the shortest way, with the least turn, that no wall bars;
/// nothing if there is no such place.
std::optional<Eigen::Vector2d> place_aside(const WalkSpace& space, const RobotBody& robot,
                                           const Agent& agent);

}  // namespace castaway::sim
