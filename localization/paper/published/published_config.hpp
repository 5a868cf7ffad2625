/// Settings of the localizer that the authors of MH-AMCL published.
#pragma once

#include "localization/paper/paper_config.hpp"
#include "localization/paper/published/published_defects.hpp"
#include "localization/paper/published/published_gates.hpp"
#include "localization/paper/published/step_noise.hpp"

namespace castaway::localization {

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
