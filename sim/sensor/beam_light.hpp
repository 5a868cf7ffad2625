/// Light effects on one beam: glass, dust, mixed pixels and lost returns.
#pragma once

#include <cstdint>
#include <utility>

#include "sim/casting/surfaces.hpp"
#include "sim/casting/surroundings.hpp"
#include "sim/common/random.hpp"
#include "sim/sensor/light_effects.hpp"

namespace castaway::sim {

/// Random streams of one lidar, one per effect, so that no effect shifts the draws of another.
struct LidarDraws {
  Rng noise{};
  Rng pattern{};
  Rng edges{};
  Rng glass{};
  Rng dust{};
  Rng dropout{};
  Rng stamps{};
};

/// Applies the light effects to a beam.
class BeamLight {
 public:
  BeamLight(const LightEffects& effects, Surfaces surfaces, double range_max)
      : effects_(effects), surfaces_(std::move(surfaces)), range_max_(range_max) {}

  /// Returns the echo of a beam. `across`: unit vector perpendicular to the beam, in the scan's
  /// plane.
  [[nodiscard]] Echo echo(const Surroundings& around, const Ray& ray, const Eigen::Vector3d& across,
                          LidarDraws& draws, std::uint32_t guess) const;

  void set_surfaces(const Surfaces& surfaces) { surfaces_ = surfaces; }

 private:
  [[nodiscard]] double cosine(const Surroundings& around, const Ray& ray, const Echo& echo) const;
  /// The first surface that returns light; panes of glass may let it pass.
  [[nodiscard]] Echo first_mirror(const Surroundings& around, Ray ray, Rng& rng,
                                  std::uint32_t guess) const;
  [[nodiscard]] double mix_ranges(const Surroundings& around, const Ray& ray,
                                  const Eigen::Vector3d& across, const Echo& echo, Rng& rng) const;
  [[nodiscard]] bool is_lost(const Echo& echo, Rng& rng) const;

  LightEffects effects_;
  Surfaces surfaces_;
  double range_max_;  ///< [m]
};

}  // namespace castaway::sim
