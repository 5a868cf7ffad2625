/// Exhaustive search: the score of every free coarse cell at every yaw.
///
/// E. Olson, "Real-Time Correlative Scan Matching", ICRA 2009; 16 neighbouring places are scored at
/// once (`tile_sums`), because their bytes for one yaw and beam are adjacent in memory.
#pragma once

#include "localization/map/pooled_field.hpp"
#include "localization/matching/best_places.hpp"
#include "localization/matching/search_space.hpp"

namespace castaway::localization {

/// Offers all free cells of a space to `best`; `scans[i]` is the scan rotated by the yaw
/// `space.yaws[i]`. `cells` is the finest level, edge 1. Constant time: one byte sum for every
/// cell, yaw and end point.
void score_all(const PooledField& cells, const SearchSpace& space,
               const std::vector<std::vector<CellOffset>>& scans, BestPlaces& best);

}  // namespace castaway::localization
