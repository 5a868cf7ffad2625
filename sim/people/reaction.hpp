/// How people react to the robot.
///
/// * regular: keeps its distance as from another person (social force);
/// * impassive: walks around it as around a piece of furniture, at any speed of the robot;
/// * surprised, within 3 m: stops and looks at it for 4 s; not again for 15 s;
/// * curious, within 4 m: approaches it to 0.9 m and looks at it for up to 12 s; not again for 20
/// s;
/// * scared, within 3 m: walks off, 25 % faster than usual, until it is 4 m away;
/// * threatening, within 4 m: blocks its way, 0.8 m ahead of it, for up to 12 s; not again for 20
/// s.
///
/// All but the first two need to see the robot; distances are between centres. Modelled on the six
/// behaviours of N. Perez-Higueras, R. Otero, F. Caballero and L. Merino, "HuNavSim: A ROS 2 Human
/// Navigation Simulator for Benchmarking Human-Aware Robot Navigation", 2023.
/// moods.
#pragma once

#include <optional>

#include "sim/people/agent.hpp"
#include "sim/people/robot_body.hpp"

namespace castaway::sim {

/// What a person does because of the robot.
struct Reaction {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Wanted.
  bool faces_robot = true;  ///< Looks at the robot; false: where it walks.
};

/// True of behaviours that react to a robot in sight.
inline bool reacts(Behaviour behaviour) {
  return behaviour != Behaviour::kRegular && behaviour != Behaviour::kImpassive;
}

/// Returns the reaction of a person at time `now` [s]; nothing if it goes on with what it was
/// doing. Stores in the agent how long it will react to the robot.
std::optional<Reaction> react(Agent& agent, const RobotBody& robot, double now);

}  // namespace castaway::sim
