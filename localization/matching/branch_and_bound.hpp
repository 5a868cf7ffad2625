/// Exact search by upper bounds: gives the same list of places as the exhaustive search, with a
/// fraction of the scores.
///
/// Branch and bound over (x, y) at every yaw with max-pooled fields, after W. Hess, D. Kohler, H.
/// Rapp, D. Andor, "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016, section V-B. Differences:
/// it finds the best places of many neighbourhoods instead of one, bounds 16 neighbouring nodes at
/// once (`PooledField`), and searches best-first at the coarsest level only and depth-first below.
/// If no bound prunes, three levels cost 1 + 1/4 + 1/16 of the exhaustive search.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "localization/map/pooled_field.hpp"
#include "localization/matching/best_places.hpp"
#include "localization/matching/scan_shifts.hpp"
#include "localization/matching/search_space.hpp"
#include "localization/matching/tile_sums.hpp"

namespace castaway::localization {

/// Levels of a map, the finest (edge 1) first; each has twice the edge of the previous one.
using Pyramid = std::vector<PooledField>;

/// Builds a pyramid of `levels` >= 1.
Pyramid make_pyramid(const ByteField& field, int levels);

/// A tile and the upper bounds of its children.
struct BoundedTile {
  Tile tile;
  ChildBounds children;

  /// The largest bound.
  [[nodiscard]] int bound() const { return *std::max_element(children.begin(), children.end()); }
};

/// The end points of a scan at every yaw of a search, on every level of a pyramid, which must
/// outlive it. Counts the tiles scored.
class TileScorer {
 public:
  /// `scans[i]` is the scan rotated by yaw i.
  TileScorer(const Pyramid& pyramid, const std::vector<std::vector<CellOffset>>& scans);

  [[nodiscard]] std::size_t top_level() const { return pyramid_->size() - 1; }
  [[nodiscard]] const PooledField& level(std::size_t level) const { return (*pyramid_)[level]; }
  /// Scores of a tile of the finest level (`tile_sums`).
  TileSums score(const Tile& tile, int least);
  /// Bounds of a tile of a coarse level (`tile_bounds`).
  BoundedTile bound(std::size_t level, const Tile& tile, int least);
  /// Work so far, in tiles of the finest level with 64 end points. In the same time, 96 end points
  /// of a coarse level are summed.
  [[nodiscard]] std::int64_t scored() const { return work_ / (64 * kFineWork); }

 private:
  static constexpr std::int64_t kFineWork = 3;  ///< Of an end point at the finest level.
  static constexpr std::int64_t kCoarseWork = 2;

  const Pyramid* pyramid_;
  ScanShifts shifts_;
  std::int64_t work_ = 0;  ///< Of the end points of all tiles.
};

/// One search. It can be interrupted and resumed at any tile.
class BranchAndBound {
 public:
  /// `scans[i]` is the scan rotated by the yaw `space.yaws[i]`. The pyramid must outlive the
  /// search.
  BranchAndBound(const Pyramid& pyramid, SearchSpace space,
                 const std::vector<std::vector<CellOffset>>& scans, BestPlaces best);

  /// Continues for the work of about `tiles` more tiles (at least one, up to a few more). Returns
  /// true when the search is complete.
  bool step(std::int64_t tiles);
  /// True if the list is final.
  [[nodiscard]] bool complete() const { return complete_; }
  /// Work so far, in tiles of the finest level (`TileScorer::scored`).
  [[nodiscard]] std::int64_t tiles_scored() const { return scorer_.scored(); }
  /// The best places so far, best first.
  [[nodiscard]] const BestPlaces& best() const { return best_; }
  /// The same, for another search; this one ends.
  [[nodiscard]] BestPlaces take_best() && { return std::move(best_); }

 private:
  void visit_next_root();
  void expand(std::size_t level, const BoundedTile& parent);
  void descend(std::size_t level, const Tile& tile);

  TileScorer scorer_;
  SearchSpace space_;
  BestPlaces best_;
  std::vector<Tile> tiles_;           ///< Tiles of the coarsest level.
  std::size_t visited_ = 0;           ///< Number of these visited, counted at every yaw.
  std::vector<BoundedTile> roots_;    ///< Those with a sufficient bound.
  std::vector<std::uint32_t> order_;  ///< Indices of the roots, best first, once all are visited.
  std::size_t expanded_ = 0;          ///< Number of finished roots.
  bool complete_ = false;
};

}  // namespace castaway::localization
