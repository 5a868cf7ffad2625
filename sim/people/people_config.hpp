/// Which people there are.
#pragma once

#include <numeric>
#include <optional>
#include <vector>

#include "sim/common/geometry.hpp"
#include "sim/people/bodies/person.hpp"

namespace castaway::sim {

/// People of a run. They are numbered in this order: placed, standing, talking, walking.
struct PeopleConfig {
  int walking = 0;            ///< Walk from place to place; all kinds together at most 200.
  int standing = 0;           ///< Stand somewhere, alone.
  std::vector<int> talking;   ///< Sizes of groups that stand and talk, 2 to 6 each.
  std::vector<Pose2> placed;  ///< Stand right here.
  double in_groups = 0.0;     ///< Of the walking, the share that go in groups of 2 to 4. [0, 1]
  /// What they all do about the robot; nothing: mixed, half of them regular, a tenth each other.
  std::optional<Behaviour> behaviour = Behaviour::kRegular;
  /// Share of the lidar's beams that walking people try to block, (0, 0.6]; 0: no crowd.
  double blocked_share = 0.0;
  bool robot_yields = true;  ///< A robot that the truth drives stops before people.

  /// How many in all.
  [[nodiscard]] int count() const {
    return std::accumulate(talking.begin(), talking.end(),
                           walking + standing + static_cast<int>(placed.size()));
  }
};

/// Most people in a run.
inline constexpr int kMaxPeople = 200;

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const PeopleConfig& config);

}  // namespace castaway::sim
