/// The best places of a search, one per neighbourhood (non-maximum suppression), independent of the
/// order in which they are offered.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// A place on the search grid and its score.
struct Place {
  int column = 0;  ///< Column of the coarse cell of base.
  int row = 0;     ///< Row of the coarse cell of base.
  int yaw = 0;     ///< Index of the yaw step.
  int score = 0;   ///< Sum of the bytes under the end points.

  bool operator==(const Place&) const = default;
};

/// Size of a neighbourhood: bins of `cells` x `cells` coarse cells and `yaws` steps, starting at
/// (0, 0, 0).
struct BinSize {
  int cells = 8;
  int yaws = 3;
};

/// The best `count` bins. A bin is represented by its highest score, and among equal scores by the
/// first place in (yaw, row, column). Bins are listed by score, and among equal scores in (yaw,
/// row, column) of bins. Scores of 0 are never listed.
///
/// This order is total, so every search that offers all places with a score of at least the final
/// `threshold` (which never decreases) gives the same list.
class BestPlaces {
 public:
  /// For a grid; no score exceeds `max_score`. Scores below `least` are never
  /// listed.
  BestPlaces(const GridFrame& frame, const BinSize& size, int count, int max_score, int least = 1);

  /// Places with a lower score can no longer change the list.
  [[nodiscard]] int threshold() const { return threshold_; }
  void offer(const Place& place);
  /// The list, best first.
  [[nodiscard]] std::vector<Place> list() const;

 private:
  void raise_threshold(int before, int now);

  BinSize size_;
  int columns_, rows_, count_;
  /// The best place of every bin that was offered one; sparse, since a large map has millions.
  std::map<int, Place> bins_;
  std::vector<int> bins_of_score_;  ///< Number of bins with this best score.
  int threshold_ = 1;
  int bins_above_ = 0;  ///< Number of bins above the threshold.
};

}  // namespace castaway::localization
