/// Changes of the world in a simulated run: when each takes place.
#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/events/world_change.hpp"

namespace castaway::sim {

/// What a solid object may not be put onto. Frame map.
struct Occupants {
  Eigen::Vector2d robot = Eigen::Vector2d::Zero();  ///< [m] Position of base.
  double robot_radius = 0.0;                        ///< [m]
  std::vector<Eigen::Vector2d> people;              ///< [m]
};

/// True if an object, and what it needs around it on a grid of `resolution` [m], is clear of robot
/// and people.
bool is_clear(const WorldObject& object, const Occupants& occupants, double resolution);

/// Holds the changes that are to come. They take place one after the other: one that has no room
/// waits, and so do those behind it.
class WorldStage {
 public:
  /// Sorts by time. @throws std::invalid_argument as `validate`, and as `apply` if the changes are
  /// impossible in `world`.
  WorldStage(const WorldSpec& world, std::vector<WorldChange> changes);

  /// Adds a change to a world as it is. @throws as the constructor.
  void add(const WorldChange& change, const WorldSpec& world);
  /// True if a change is due at `now`; one that waits is due every 50 ms.
  [[nodiscard]] bool due(std::chrono::nanoseconds now) const;
  /// Hands the changes that are due to `make`, which returns false if there is no room.
  void advance(std::chrono::nanoseconds now,
               const std::function<bool(const WorldChange& change)>& make);

 private:
  std::vector<WorldChange> waiting_;  ///< In order of time.
  std::chrono::nanoseconds next_try_{};
};

}  // namespace castaway::sim
