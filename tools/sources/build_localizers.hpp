/// Localizers and the loop from a scenario.
#pragma once

#include "tools/run/loop.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// One localizer for each specification, on one map, each with its own stream of the seed and with
/// a clock for its stages. Throws std::invalid_argument where a map or a setting cannot be used.
std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const localization::OccupancyGrid& map,
                                             std::uint64_t seed);

/// How a run of the scenario goes that starts at `start`, as far as the loop is concerned.
LoopConfig loop_config(const Scenario& scenario, const SE2& start);

}  // namespace castaway::testbed
