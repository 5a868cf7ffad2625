/// Changes a world after its map was made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/map/grid.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// One change by name.
struct Change {
  enum class Kind { kMove, kRemove, kOpen, kClose, kAdd };

  Kind kind = Kind::kMove;
  std::string name = {};         ///< Of the piece of furniture or the door; empty for kAdd.
  Eigen::Vector2d by{0.0, 0.0};  ///< [m] In map; for kMove.
  double turn_deg = 0.0;         ///< [deg] About the centre; for kMove.
  double open_deg = 90.0;        ///< [deg] For kOpen.
  std::vector<WorldObject> objects = {};  ///< For kAdd.
};

/// How a world differs from its map. Shares are in [0, 1].
struct DifferenceSpec {
  std::vector<Change> changes;  ///< Named changes; applied first, in order.
  double move_furniture = 0.0;  ///< Share of the movable pieces that are moved.
  /// [m] Largest displacement of a moved piece; it also turns by up to 45 degrees.
  double reach_m = 2.0;
  double remove = 0.0;                ///< Share of the movable pieces that are removed.
  double close_doors = 0.0;           ///< Share of the open doors that are closed.
  double open_doors = 0.0;            ///< Share of the closed doors that are opened wide.
  int add_boxes = 0;                  ///< Number of boxes of 0.3 to 0.8 m that are added.
  std::optional<std::uint64_t> seed;  ///< Replaces the run's seed.

  [[nodiscard]] bool empty() const;
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const DifferenceSpec& spec);

/// Areas that must stay passable.
struct KeepClear {
  /// [m] Closed routes; nothing is put within 0.45 m.
  std::vector<std::vector<Eigen::Vector2d>> routes;
  std::optional<Eigen::Vector2d> start;  ///< [m] Nothing is put within 0.6 m.
};

/// A world that has changed.
struct ChangedWorld {
  WorldSpec world;                 ///< Moved and removed objects stay on the map.
  int moved = 0;                   ///< Pieces.
  int removed = 0;                 ///< Pieces.
  int opened = 0;                  ///< Doors.
  int closed = 0;                  ///< Doors.
  int added = 0;                   ///< Objects.
  std::vector<std::string> notes;  ///< Changes that were impossible, one per line.
};

/// Changes a world. `map` is its survey. Pieces that overlap when seen from above (a chair under a
/// table, a monitor on it) change together. Whatever is drawn at random keeps 3 cm from everything,
/// stays where the map is known, keeps routes and start clear, and stays 0.8 m away from doors; a
/// piece without such a place is not moved. Named changes are applied without these checks.
/// @throws std::invalid_argument if a name is not in the world, std::runtime_error if a mesh cannot
/// be read.
ChangedWorld change_world(WorldSpec world, const DifferenceSpec& spec, const Grid& map,
                          const KeepClear& keep, Rng& rng);

}  // namespace castaway::sim
