/// Plays a scenario with all variants of the published MH-AMCL on the same frames.
#pragma once

#include <filesystem>
#include <functional>

#include "tests/bench/workbench/published_variants.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Returns the scores in the order of the variants, over `seeds` runs whose seeds start at the
/// scenario's. The scenario's own localizers are not used; the true pose drives the robot. All
/// variants draw the same random numbers, so a variant whose defect has no effect equals `paper`
/// bit by bit. `base`: as in `build_simulation`. `on_run` is called after each run.
std::vector<VariantScore> play_variants(
    Scenario scenario, const std::filesystem::path& base,
    const std::vector<PublishedVariant>& variants, int seeds,
    const std::function<void()>& on_run = [] {});

}  // namespace castaway::testbed
