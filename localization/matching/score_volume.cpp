#include "localization/matching/score_volume.hpp"

#include "localization/matching/scan_shifts.hpp"
#include "localization/matching/tiles.hpp"

namespace castaway::localization {

void score_all(const PooledField& cells, const SearchSpace& space,
               const std::vector<std::vector<CellOffset>>& scans, BestPlaces& best) {
  ScanShifts shifts(1, scans);
  std::vector<Tile> tiles = tiles_within(cells, space);
  for (std::size_t yaw = 0; yaw < space.yaws.size(); ++yaw) {
    for (Tile& tile : tiles) {
      tile.yaw = static_cast<int>(yaw);
      offer_tile(cells, space, tile,
                 tile_sums(cells, tile, shifts.at(cells.layout(), yaw), best.threshold()).sums,
                 best);
    }
  }
}

}  // namespace castaway::localization
