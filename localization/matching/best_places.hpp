/// The best places of a search, one per neighbourhood (non-maximum suppression), whatever the order
/// in which they are offered.
#pragma once

#include <cstdint>
#include <vector>

#include "localization/map/occupancy_grid.hpp"

namespace castaway::localization {

/// A place on the search grid and its score.
struct Place {
  int column = 0;  ///< Coarse cell...
  int row = 0;     ///< ...that base stands in.
  int yaw = 0;     ///< Step of the yaw.
  int score = 0;   ///< Sum of the bytes under the end points.

  bool operator==(const Place&) const = default;
};

/// Size of a neighbourhood: bins of `cells` x `cells` coarse cells and `yaws` steps, from (0, 0,
/// 0).
struct BinSize {
  int cells = 8;
  int yaws = 3;
};

/// The best `count` bins. A bin is represented by its highest score, of equal ones by the first in
/// (yaw, row, column); bins are listed by score, of equal ones by the first in (yaw, row, column)
/// of bins. Scores of 0 are never listed.
///
/// This order is total, so every search that offers all places with a score of at least the final
/// `threshold` (which never sinks) gives the same list.
class BestPlaces {
 public:
  /// For a grid of places of `yaws` steps; no score exceeds `max_score`.
  BestPlaces(const GridFrame& frame, int yaws, const BinSize& size, int count, int max_score);

  /// Places with a lower score cannot change the list any more.
  [[nodiscard]] int threshold() const { return threshold_; }
  void offer(const Place& place);
  /// The list, best first.
  [[nodiscard]] std::vector<Place> list() const;

 private:
  void raise_threshold(int before, int now);

  BinSize size_;
  int columns_, rows_, count_;
  std::vector<Place> bins_;
  std::vector<int> bins_of_score_;  ///< How many bins have this score as their best.
  int threshold_ = 1;
  int bins_above_ = 0;  ///< How many bins are above the threshold.
};

}  // namespace castaway::localization
