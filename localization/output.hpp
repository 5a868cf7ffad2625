/// What a localizer of several populations tells: the estimate with its alternatives, and its
/// diagnostics.
#pragma once

#include <optional>
#include <vector>

#include "localization/hypotheses/populations.hpp"
#include "localization/localizer.hpp"
#include "localization/sensor/intake.hpp"
#include "localization/stage_timer.hpp"

namespace castaway::localization {

/// The output as the pose at `stamp`; nothing without an output. `shares`: of the populations, in
/// their order. `T_now_base`: base at `stamp` in base as the populations have it.
std::optional<Estimate> estimate_of(const Populations& populations,
                                    const std::vector<double>& shares, bool lost, Stamp stamp,
                                    const SE2& T_now_base);

/// All populations, with the counters of what came in and the cost of the stages.
Diagnostics diagnostics_of(const Populations& populations, const std::vector<double>& shares,
                           const Intake& intake, const StageTimer& timer);

}  // namespace castaway::localization
