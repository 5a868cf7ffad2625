/// The difference layer: what changed in a world after its map was made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/map/grid.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// One change by name.
struct Change {
  enum class Kind { kMove, kRemove, kOpen, kClose, kAdd };

  Kind kind = Kind::kMove;
  std::string name = {};                  ///< Of the piece or the door; empty for kAdd.
  Eigen::Vector2d by{0.0, 0.0};           ///< [m] In map; kMove.
  double turn_deg = 0.0;                  ///< About its middle; kMove.
  double open_deg = 90.0;                 ///< kOpen.
  std::vector<WorldObject> objects = {};  ///< kAdd.
};

/// How a world differs from its map. Shares are in [0, 1].
struct DifferenceSpec {
  std::vector<Change> changes;        ///< By name; carried out first, in order.
  double move_furniture = 0.0;        ///< Share of the movable pieces that are moved...
  double reach_m = 2.0;               ///< [m] ...by at most so far, and turned by up to 45 degrees.
  double remove = 0.0;                ///< Share of the movable pieces that are gone.
  double close_doors = 0.0;           ///< Share of the open doors that are closed.
  double open_doors = 0.0;            ///< Share of the closed doors that stand wide open.
  int add_boxes = 0;                  ///< Boxes of 0.3 to 0.8 m that stand about.
  std::optional<std::uint64_t> seed;  ///< Instead of the run's.

  [[nodiscard]] bool empty() const;
};

/// Throws std::invalid_argument if a figure is out of its range.
void validate(const DifferenceSpec& spec);

/// What must stay passable.
struct KeepClear {
  std::vector<std::vector<Eigen::Vector2d>> routes;  ///< [m] Closed; nothing within 0.45 m.
  std::optional<Eigen::Vector2d> start;              ///< [m] Nothing within 0.6 m.
};

/// A world that has changed.
struct ChangedWorld {
  WorldSpec world;                 ///< What was moved or taken away stays on the map.
  int moved = 0;                   ///< Pieces.
  int removed = 0;                 ///< Pieces.
  int opened = 0;                  ///< Doors.
  int closed = 0;                  ///< Doors.
  int added = 0;                   ///< Objects.
  std::vector<std::string> notes;  ///< What could not be done, one a line.
};

/// Changes a world. `map` is its survey. Pieces that overlap seen from above (a chair under a
/// table, a monitor on it) change together. Whatever is drawn at random keeps 3 cm from everything,
/// stays where the map is known, keeps routes and start clear and stays 0.8 m away from doors; a
/// piece without such a place stays where it is. Changes by name are carried out as given.
/// @throws std::invalid_argument if a name is not of the world, std::runtime_error if a mesh cannot
/// be read.
ChangedWorld change_world(WorldSpec world, const DifferenceSpec& spec, const Grid& map,
                          const KeepClear& keep, Rng& rng);

}  // namespace castaway::sim
