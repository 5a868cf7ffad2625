/// Plays a scenario with all variants of the published MH-AMCL on the same frames.
#pragma once

#include <filesystem>
#include <functional>

#include "tools/scenario/sections/scenario.hpp"
#include "tools/trials/published_variants.hpp"

namespace castaway::testbed {

/// Scores in the order of the variants, over `seeds` runs with the scenario's seed and those after
/// it. The scenario's own localizers do not ride; the truth drives. All variants draw the same
/// random numbers, so that one whose defect changes nothing is `paper` to the bit. `base`: as in
/// `build_simulation`. `on_run` is called after each run.
std::vector<VariantScore> play_variants(
    Scenario scenario, const std::filesystem::path& base,
    const std::vector<PublishedVariant>& variants, int seeds,
    const std::function<void()>& on_run = [] {});

}  // namespace castaway::testbed
