/// Checks whether there is room for something in a world.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "sim/difference/difference.hpp"
#include "sim/world/slice.hpp"

namespace castaway::sim {

/// The footprints of all objects in a world, and the areas that must stay passable.
class RoomCheck {
 public:
  /// `map`: the world's survey; must outlive this.
  RoomCheck(const WorldSpec& world, const Grid& map, const KeepClear& keep);

  /// True if all `outlines` keep clear of routes, start, door openings and all objects except
  /// `except`, and lie where the map is known.
  [[nodiscard]] bool fits(const std::vector<ConvexOutline>& outlines,
                          const std::vector<std::size_t>& except) const;
  /// True if the outline of a door's leaf keeps clear of routes, start and movable objects; it may
  /// touch posts.
  [[nodiscard]] bool leaf_fits(const ConvexOutline& leaf) const;
  /// Updates an object that was added, moved or removed.
  void update(const WorldSpec& world, std::size_t object);

 private:
  [[nodiscard]] bool passable(const ConvexOutline& outline) const;
  [[nodiscard]] bool is_known(const ConvexOutline& outline) const;

  struct Standing {
    bool there = false;
    bool movable = false;
    ConvexOutline outline;
    Eigen::AlignedBox2d box;
  };

  const Grid& map_;
  std::vector<Standing> standing_;        ///< By object.
  std::vector<Eigen::Vector2d> way_;      ///< [m] Points of the routes.
  std::vector<Eigen::Vector2d> doors_;    ///< [m] Middles of the openings.
  std::optional<Eigen::Vector2d> start_;  ///< [m]
};

}  // namespace castaway::sim
