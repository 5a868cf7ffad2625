/// A person with its intentions: what `people.hpp` moves. Internal to sim/people.
#pragma once

#include <cstddef>

#include "sim/common/random.hpp"
#include "sim/people/bodies/person.hpp"

namespace castaway::sim {

/// What a person is here for.
enum class Errand { kStanding, kWalking };

/// Everything about one person. Times are seconds since the start of the run.
struct Agent {
  PersonBody body;
  Behaviour behaviour = Behaviour::kRegular;
  Errand errand = Errand::kWalking;
  std::size_t leader = 0;  ///< First of its group, whose goals it shares; itself if alone.
  int rank = 0;            ///< In the group; 0: the leader.
  Rng rng;                 ///< Its own: nobody else draws from it.

  PersonState state;
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  ///< [m] Where who stands belongs...
  double anchor_heading = 0.0;                       ///< [rad] ...and faces.

  std::size_t goal = 0;                                ///< Place that a walker goes to...
  Eigen::Vector2d waypoint = Eigen::Vector2d::Zero();  ///< [m] ...by way of this point...
  double rests_until = 0.0;                            ///< [s] ...once it has rested.
  double headway = 0.5;                                ///< [m/s] Lately, towards where it wants.
  double stuck_for = 0.0;                              ///< [s] Wanted to walk and could not.

  double busy_until = 0.0;                         ///< [s] Minds the robot so long...
  double unmoved_until = 0.0;                      ///< [s] ...and then not before.
  bool sees_robot = false;                         ///< No wall between.
  bool in_crowd = false;                           ///< Goes to `slot` rather than to its goal.
  Eigen::Vector2d slot = Eigen::Vector2d::Zero();  ///< [m] Its place in the crowd.
};

}  // namespace castaway::sim
