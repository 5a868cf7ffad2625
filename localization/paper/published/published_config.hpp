/// Settings of the localizer that the authors of MH-AMCL published.
#pragma once

#include <vector>

#include "localization/geometry/random.hpp"
#include "localization/geometry/se2.hpp"
#include "localization/hypotheses/hypothesis.hpp"
#include "localization/paper/paper_config.hpp"
#include "localization/paper/published/published_defects.hpp"

namespace castaway::localization {

/// The thresholds. A right pose among many people has a quality of 0.14 to 0.55 and is never
/// selected.
struct PublishedGates {
  /// Another population must have a higher quality than this to become the output.
  double good = 0.6;
  double margin = 0.2;  ///< Its quality must also exceed the output's by this.
  double low = 0.25;    ///< Populations below this are removed if there are as many as allowed.
  /// Populations below this are always removed, except the last remaining one.
  double very_low = 0.1;
};

/// Returns the id of the output that the published code selects: the present one (the first one if
/// it is gone) unless another passes the gates. Requires populations.
int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id);

/// True if a population is removed, where there are `count` of at most `most`.
bool fails_gates(const PublishedGates& gates, const Hypothesis& hypothesis, std::size_t count,
                 int most);

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

/// The paper's settings, and those of the published code's differences.
struct PublishedMhAmclConfig {
  PaperMhAmclConfig paper;
  PublishedDefects defects;
  PublishedGates gates;        ///< Used with `absolute_gates`.
  StepNoiseConfig step_noise;  ///< Used with `noise_per_step`.
};

/// All defects, and the published values: new populations spread by 0.1 m and 0.05 rad, 3 %
/// winners, and copies spread as in new populations.
PublishedMhAmclConfig published_config();

}  // namespace castaway::localization
