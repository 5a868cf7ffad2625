/// All that beams can meet: what stands, what moves, and the floor.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/casting/moving_scene.hpp"
#include "sim/casting/ray_scene.hpp"
#include "sim/casting/surfaces.hpp"

namespace castaway::sim {

/// All that a beam can meet, floor aside. Holds references: the scenes must outlive it.
struct Surroundings {
  Surroundings(const RayScene& standing) : fixed(standing) {}  // NOLINT: a scene is surroundings.
  Surroundings(const RayScene& standing, const MovingScene& movers)
      : fixed(standing), moving(&movers) {}

  const RayScene& fixed;
  const MovingScene* moving = nullptr;  ///< May be missing.
};

/// The nearest hit of a ray within `max_distance` [m] in all surroundings; its `primitive` is of
/// the fixed scene, also where something that moves is in front of it. `guess`: as in
/// `RayScene::cast`.
std::optional<RayHit> cast(const Surroundings& around, const Ray& ray, double max_distance,
                           std::uint32_t guess = kNoPrimitive);

/// Where light comes back from, the floor included.
struct Echo {
  double range = kNoHit;                   ///< [m] kNoHit: from nowhere.
  int object = kHitNothing;                ///< Label of what it met.
  std::uint32_t primitive = kNoPrimitive;  ///< As in `cast`: the next guess.
  double cosine = 1.0;                     ///< Of the angle of incidence, [0, 1].
  double reflectivity = 0.0;               ///< Of the surface, [0, 1].
  bool met = false;                        ///< Its line meets something within range.
};

/// The first thing that a ray meets within `max_distance` [m]; nothing is said of its surface.
Echo first_echo(const Surroundings& around, const Ray& ray, double max_distance,
                std::uint32_t guess = kNoPrimitive);

}  // namespace castaway::sim
