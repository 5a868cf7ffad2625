/// Builds localizers and the loop's configuration from a scenario.
#pragma once

#include "tools/run/loop.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Builds one localizer per specification on one map. Each has its own random substream of the seed
/// and a clock for its stages. Throws std::invalid_argument if a map or a setting is unusable.
std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const localization::OccupancyGrid& map,
                                             std::uint64_t seed);

/// Configuration of the loop for a run of the scenario that starts at `start`.
LoopConfig loop_config(const Scenario& scenario, const SE2& start);

}  // namespace castaway::testbed
