/// Everything that beams can hit: static objects, moving bodies, and the floor.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/casting/moving_scene.hpp"
#include "sim/casting/ray_scene.hpp"
#include "sim/casting/surfaces.hpp"

namespace castaway::sim {

/// Everything that a beam can hit except the floor. Holds references: the scenes must outlive it.
struct Surroundings {
  Surroundings(const RayScene& standing) : fixed(standing) {}  // NOLINT: a scene is surroundings.
  Surroundings(const RayScene& standing, const MovingScene& movers)
      : fixed(standing), moving(&movers) {}

  const RayScene& fixed;
  const MovingScene* moving = nullptr;  ///< nullptr if nothing moves.
};

/// The nearest hit of a ray within `max_distance` [m] in all surroundings. Its `primitive` is that
/// of the static scene even if a moving body is in front of it. `guess`: as in `RayScene::cast`.
std::optional<RayHit> cast(const Surroundings& around, const Ray& ray, double max_distance,
                           std::uint32_t guess = kNoPrimitive);

/// Where the light of a beam returns from, the floor included.
struct Echo {
  double range = kNoHit;                   ///< [m] kNoHit if no light returns.
  int object = kHitNothing;                ///< Label of what it hit.
  std::uint32_t primitive = kNoPrimitive;  ///< As in `cast`: guess for the next beam.
  double cosine = 1.0;                     ///< Of the angle of incidence, [0, 1].
  double reflectivity = 0.0;               ///< Of the surface, [0, 1].
  bool met = false;                        ///< The beam hits something within range.
};

/// The first surface that a ray hits within `max_distance` [m]; without values for the surface.
Echo first_echo(const Surroundings& around, const Ray& ray, double max_distance,
                std::uint32_t guess = kNoPrimitive);

}  // namespace castaway::sim
