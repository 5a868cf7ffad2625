/// Draws the people of a run. Internal to sim/people.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/people/agent.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/people_config.hpp"
#include "sim/people/robot_body.hpp"

namespace castaway::sim {

/// A person of a stream "people/<name>", not placed yet. `behaviour`: nothing if it is drawn.
Agent draw_agent(const std::string& name, Errand errand, std::optional<Behaviour> behaviour,
                 const NamedStreams& streams);
/// Lets a person stand at a place, which it returns to. `heading` [rad]
void place_agent(const Eigen::Vector2d& p_map, double heading, Agent& agent);

/// Draws all people of `config`, in its order, apart from each other and from the robot. @throws
/// std::runtime_error naming the person for whom there is no room.
std::vector<Agent> draw_people(const PeopleConfig& config, const WalkSpace& space,
                               const GoalFields& goals, const RobotBody& robot,
                               const NamedStreams& streams);

}  // namespace castaway::sim
