/// The global search written directly from its definition, without optimisation. It is the
/// reference of the benchmarks and an oracle for tests.
#pragma once

#include "localization/matching/cascade_matcher.hpp"
#include "tools/batch/bench/plain_reference.hpp"

namespace castaway::testbed {

/// The best place with its score in [0, 1], as `CascadeMatcher` computes it, over every free cell
/// at the config's resolution and every yaw.
localization::Candidate plain_match(const localization::MatcherConfig& config,
                                    const localization::OccupancyGrid& grid,
                                    const localization::DistanceField& distances,
                                    const PlainScan& scan);

}  // namespace castaway::testbed
