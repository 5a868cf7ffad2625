/// Draws the people of a run. Internal to sim/people.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/people_config.hpp"
#include "sim/people/robot_body.hpp"

namespace castaway::sim {

/// Draws all people of `config`, in its order, apart from each other and from the robot. @throws
/// std::runtime_error naming the person for whom there is no room.
std::vector<Agent> draw_people(const PeopleConfig& config, const WalkSpace& space,
                               const GoalFields& goals, const RobotBody& robot,
                               const NamedStreams& streams);

}  // namespace castaway::sim
