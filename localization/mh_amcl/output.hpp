/// Output of a localizer with several populations: estimate, alternatives and diagnostics.
#pragma once

#include <optional>
#include <vector>

#include "castaway/localizer.hpp"
#include "localization/geometry/stage_timer.hpp"
#include "localization/hypotheses/populations.hpp"
#include "localization/input/intake.hpp"

namespace castaway::localization {

/// Returns the output as the pose at `stamp`; nothing without an output. `shares`: of the
/// populations, in their order. `T_now_base`: pose of base at `stamp`, relative to base at the time
/// of the populations.
std::optional<Estimate> estimate_of(const Populations& populations,
                                    const std::vector<double>& shares, bool lost, Stamp stamp,
                                    const SE2& T_now_base);

/// Returns all populations, the counters of dropped readings and the CPU time of the stages.
Diagnostics diagnostics_of(const Populations& populations, const std::vector<double>& shares,
                           const Intake& intake, const StageTimer& timer);

}  // namespace castaway::localization
