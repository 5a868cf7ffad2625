/// Odometry motion model of the published MH-AMCL (`PublishedDefects::noise_per_step`): the noise
/// of a step is a random share of it.
#pragma once

#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Standard deviations of the shares.
struct StepNoiseConfig {
  /// Share of the step's translation, one draw for x and y: no sideways noise.
  double trans = 0.01;
  double rot = 0.01;  ///< Share of the step's rotation: none while driving straight.
};

/// One step of odometry, conditioned once and applied to many poses.
class StepNoiseMotion {
 public:
  /// `u` is `T_base0_base1`, the step as odometry measured it.
  StepNoiseMotion(const SE2& u, const StepNoiseConfig& config) : u_(u), config_(config) {}

  /// Draws `x' = x * u * e`.
  [[nodiscard]] SE2 sample(const SE2& T_map_base0, Rng& rng) const;

 private:
  SE2 u_;
  StepNoiseConfig config_;
};

}  // namespace castaway::localization
