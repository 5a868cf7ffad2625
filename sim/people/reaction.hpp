/// What people do about the robot.
///
/// * regular: minds the robot as it would another person (social force);
/// * impassive: walks around it as around a piece of furniture, whatever its speed;
/// * surprised, within 3 m: stops and looks at it for 4 s; not again for 15 s;
/// * curious, within 4 m: goes up to it, to 0.9 m, and looks on for up to 12 s; not again for 20 s;
/// * scared, within 3 m: walks off, a quarter faster than it would, until it is 4 m away;
/// * threatening, within 4 m: gets in its way, 0.8 m before its front, for up to 12 s; not again
///   for 20 s.
///
/// All but the first two need to see it; distances are between middles. In the manner of N.
/// Perez-Higueras, R. Otero, F. Caballero and L. Merino, "HuNavSim: A ROS 2 Human Navigation
/// Simulator for Benchmarking Human-Aware Robot Navigation", 2023, whose people have six like
/// moods.
#pragma once

#include <optional>

#include "sim/people/agent.hpp"
#include "sim/people/robot_body.hpp"

namespace castaway::sim {

/// What a person wants because of the robot.
struct Reaction {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s] Wanted.
  bool faces_robot = true;                             ///< Looks at it; false: where it goes.
};

/// True of behaviours that mind a robot in sight.
inline bool reacts(Behaviour behaviour) {
  return behaviour != Behaviour::kRegular && behaviour != Behaviour::kImpassive;
}

/// The reaction of a person at time `now` [s]; nothing: it goes on with what it was about. Notes in
/// the agent how long the robot will hold its attention.
std::optional<Reaction> react(Agent& agent, const RobotBody& robot, double now);

}  // namespace castaway::sim
