/// The global search written straight from its definition, without any thought of speed. What the
/// benchmarks compare with, and an oracle for tests.
#pragma once

#include "localization/matching/cascade_matcher.hpp"
#include "tools/bench/plain_reference.hpp"

namespace castaway::testbed {

/// The best place and its score in [0, 1] as `CascadeMatcher` rates them: every free cell of the
/// config's resolution at every yaw.
localization::Candidate plain_match(const localization::MatcherConfig& config,
                                    const localization::OccupancyGrid& grid,
                                    const localization::DistanceField& distances,
                                    const PlainScan& scan);

}  // namespace castaway::testbed
