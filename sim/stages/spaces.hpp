/// Where robot and people can be in one world.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "sim/map/free_space.hpp"
#include "sim/people/walk_cells.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// The grids and free spaces of one world and its map, each computed when first asked for and then
/// kept, because they take longer than a short run. Runs in the same world may share them: what a
/// run gets does not depend on what was asked for before. All calls must be about equal worlds and
/// equal maps; std::logic_error is thrown for a world with another number of objects.
class Spaces {
 public:
  /// `parts`: where people can walk.
  explicit Spaces(WalkParts parts = WalkParts::kLargest) : parts_(parts) {}

  /// Free space of the map itself for a disc of `radius` [m].
  FreeSpace on_map(const Grid& map, double radius);
  /// Free space of `drive_grid`, or on the floors of `config.levels`.
  FreeSpace driving(const SimulationConfig& config, double radius);
  /// The part of it at a point, or else the largest one; not kept.
  FreeSpace driving_around(const SimulationConfig& config, double radius,
                           const Eigen::Vector2d& p_map);
  /// Free space of `landing_grid`; on levels, of `driving`.
  FreeSpace landing(const SimulationConfig& config, double radius);
  /// The floors for a robot of a height [m]; `survey` is called unless they are kept.
  std::shared_ptr<const LevelPlane> levels(
      double height, const std::function<std::shared_ptr<const LevelPlane>()>& survey);
  /// Where people can walk.
  std::shared_ptr<const WalkCells> walking(const WorldSpec& world, const Grid& map);

 private:
  using Key = std::pair<double, double>;  ///< [m] Height of the robot, if it matters, and radius.

  void require_same(const WorldSpec& world);
  const Grid& drive_grid(const SimulationConfig& config);
  const Grid& landing_grid(const SimulationConfig& config);

  WalkParts parts_;
  std::optional<std::size_t> objects_;  ///< Of the world.
  std::map<double, Grid> drive_grids_;  ///< By the height of the robot.
  std::map<double, Grid> landing_grids_;
  std::map<Key, FreeSpace> on_map_;
  std::map<Key, FreeSpace> driving_;
  std::map<Key, FreeSpace> landing_;
  std::map<double, std::shared_ptr<const LevelPlane>> levels_;  ///< By the height of the robot.
  std::shared_ptr<const WalkCells> walking_;
};

}  // namespace castaway::sim
