/// Selects the tiles of a level for a search, and offers their scores.
#pragma once

#include "localization/matching/best_places.hpp"
#include "localization/matching/tile_sums.hpp"

namespace castaway::localization {

/// True if no cell of a space lies in a tile.
bool outside(const PooledField& level, const SearchSpace& space, int column, int row);

/// Tiles with free cells inside of a space, row by row; with yaw 0.
std::vector<Tile> tiles_within(const PooledField& level, const SearchSpace& space);

/// Offers the free cells of a tile of the finest level that lie in the space.
void offer_tile(const PooledField& cells, const SearchSpace& space, const Tile& tile,
                const TileSums& scores, BestPlaces& best);

}  // namespace castaway::localization
