/// One beam's light: what it meets, through glass and dust, and whether enough of it returns.
#pragma once

#include <cstdint>
#include <utility>

#include "sim/casting/surfaces.hpp"
#include "sim/casting/surroundings.hpp"
#include "sim/common/random.hpp"
#include "sim/sensor/light_effects.hpp"

namespace castaway::sim {

/// Random numbers of one lidar: one stream for each effect, so that none shifts another.
struct LidarDraws {
  Rng noise{};
  Rng pattern{};
  Rng edges{};
  Rng glass{};
  Rng dust{};
  Rng dropout{};
};

/// The effects on one beam after the other.
class BeamLight {
 public:
  BeamLight(const LightEffects& effects, Surfaces surfaces, double range_max)
      : effects_(effects), surfaces_(std::move(surfaces)), range_max_(range_max) {}

  /// What comes back of a beam; `across`: unit vector at right angles to it, in the scan's plane.
  [[nodiscard]] Echo echo(const Surroundings& around, const Ray& ray, const Eigen::Vector3d& across,
                          LidarDraws& draws, std::uint32_t guess) const;

 private:
  [[nodiscard]] double cosine(const Surroundings& around, const Ray& ray, const Echo& echo) const;
  /// The first thing that returns light; panes of glass may let it through.
  [[nodiscard]] Echo first_mirror(const Surroundings& around, Ray ray, Rng& rng,
                                  std::uint32_t guess) const;
  [[nodiscard]] double mixed(const Surroundings& around, const Ray& ray,
                             const Eigen::Vector3d& across, const Echo& echo, Rng& rng) const;
  [[nodiscard]] bool lost(const Echo& echo, Rng& rng) const;

  LightEffects effects_;
  Surfaces surfaces_;
  double range_max_;  ///< [m]
};

}  // namespace castaway::sim
