/// People who come during a run. Internal to sim/people.
#pragma once

#include <vector>

#include "sim/common/random.hpp"
#include "sim/events/world_change.hpp"
#include "sim/people/agent.hpp"
#include "sim/people/goal_fields.hpp"
#include "sim/people/robot_body.hpp"
#include "sim/people/walk_space.hpp"

namespace castaway::sim {

/// True if there is room for the people of `arrival`, apart from those who are there already and
/// from the robot.
bool has_room(const AddPeople& arrival, const WalkSpace& space, const RobotBody& robot,
              const std::vector<Agent>& present);

/// Draws the people of `arrival`, apart from those who are there already and from the robot; none
/// if there is no room. Their numbers follow those of `present`, and so do their random streams.
std::vector<Agent> draw_arrivals(const AddPeople& arrival, const WalkSpace& space,
                                 const GoalFields& goals, const RobotBody& robot,
                                 const std::vector<Agent>& present, const NamedStreams& streams);

}  // namespace castaway::sim
