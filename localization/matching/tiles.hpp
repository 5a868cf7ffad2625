/// Which tiles of a level a search has to look at, and what becomes of their scores.
#pragma once

#include "localization/matching/best_places.hpp"
#include "localization/matching/tile_sums.hpp"

namespace castaway::localization {

/// Whether no cell of a space lies under a tile.
bool outside(const PooledField& level, const SearchSpace& space, int column, int row);

/// Tiles with free cells that are not outside of a space, row by row; yaw 0.
std::vector<Tile> tiles_within(const PooledField& level, const SearchSpace& space);

/// Offers the free cells of a tile of the finest level, as far as they are in the space.
void offer_tile(const PooledField& cells, const SearchSpace& space, const Tile& tile,
                const TileSums& scores, BestPlaces& best);

}  // namespace castaway::localization
