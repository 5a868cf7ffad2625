/// Which people a run has.
#pragma once

#include <numeric>
#include <optional>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/people/bodies/person.hpp"

namespace castaway::sim {

/// People of a run. They are numbered in the order placed, standing, talking, walking.
struct PeopleConfig {
  int walking = 0;            ///< Walk from place to place; at most 200 people of all kinds.
  int standing = 0;           ///< Stand somewhere, alone.
  std::vector<int> talking;   ///< Sizes of groups that stand and talk, 2 to 6 each.
  std::vector<Pose2> placed;  ///< Stand at these poses.
  double in_groups = 0.0;     ///< Share of the walking people that go in groups of 2 to 4, [0, 1].
  /// Behaviour of all towards the robot; nothing: mixed, half of them regular, a tenth each of the
  /// others.
  std::optional<Behaviour> behaviour = Behaviour::kRegular;
  /// Share of the lidar's beams that walking people try to block, (0, 0.6]; 0: no crowd.
  double blocked_share = 0.0;
  bool robot_yields = true;  ///< A robot that drives by its true pose stops before people.

  /// Number of all people.
  [[nodiscard]] int count() const {
    return std::accumulate(talking.begin(), talking.end(),
                           walking + standing + static_cast<int>(placed.size()));
  }
};

/// Largest number of people in a run.
inline constexpr int kMaxPeople = 200;

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const PeopleConfig& config);

}  // namespace castaway::sim
