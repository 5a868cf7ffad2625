/// State of one person, which `people.hpp` moves. Internal to sim/people.
#pragma once

#include <cstddef>

#include "sim/common/random.hpp"
#include "sim/people/bodies/person.hpp"

namespace castaway::sim {

/// What a person does when it is left alone.
enum class Errand { kStanding, kWalking };

/// All state of one person. Times are seconds since the start of the run.
struct Agent {
  PersonBody body;
  Behaviour behaviour = Behaviour::kRegular;
  Errand errand = Errand::kWalking;
  /// Index of the first of its group, whose goals it shares; its own if alone.
  std::size_t leader = 0;
  int rank = 0;  ///< Position in the group; 0 is the leader.
  Rng rng;       ///< Drawn from by this person only.

  PersonState state;
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  ///< [m] Where a standing person returns to.
  double anchor_heading = 0.0;                       ///< [rad] Heading that it returns to.

  std::size_t goal = 0;  ///< Index of the place that a walker goes to.
  Eigen::Vector2d waypoint = Eigen::Vector2d::Zero();  ///< [m] Point that it walks to next.
  double rests_until = 0.0;                            ///< [s] It rests until then.
  double headway = 0.5;    ///< [m/s] Smoothed speed towards where it wants to go.
  double stuck_for = 0.0;  ///< [s] For how long it has wanted to walk and made no headway.

  double busy_until = 0.0;     ///< [s] Reacts to the robot until then.
  double unmoved_until = 0.0;  ///< [s] Does not react to the robot again before.
  bool sees_robot = false;     ///< No wall is in between.
  bool in_crowd = false;       ///< Goes to `slot` instead of its goal.
  Eigen::Vector2d slot = Eigen::Vector2d::Zero();  ///< [m] Its place in the crowd.
};

}  // namespace castaway::sim
