/// Is there room for something in a world?
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "sim/difference/difference.hpp"
#include "sim/world/slice.hpp"

namespace castaway::sim {

/// The footprints of everything in a world, and what must stay passable.
class RoomCheck {
 public:
  /// `map`: its survey; must outlive this.
  RoomCheck(const WorldSpec& world, const Grid& map, const KeepClear& keep);

  /// True if all `outlines` keep clear of everything but the objects `except` and `doors_too` of
  /// the door openings.
  [[nodiscard]] bool fits(const std::vector<ConvexOutline>& outlines,
                          const std::vector<std::size_t>& except) const;
  /// True if an outline keeps clear of routes, start and the objects other than `except`; a door's
  /// leaf may stand at the posts that it touches.
  [[nodiscard]] bool leaf_fits(const ConvexOutline& leaf) const;
  /// An object was put, moved or taken away.
  void update(const WorldSpec& world, std::size_t object);

 private:
  [[nodiscard]] bool passable(const ConvexOutline& outline) const;
  [[nodiscard]] bool known(const ConvexOutline& outline) const;

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
