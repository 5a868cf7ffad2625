/// The best places of a search, one per neighbourhood (non-maximum suppression), independent of the
/// order in which they are offered.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
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

/// An array of places in which few are ever written: a large map has millions of bins. Storage is
/// allocated in pages.
class SparsePlaces {
 public:
  /// The place with an index, to be written; at first one without a score.
  Place& at(std::size_t i) {
    if (i / kPage >= pages_.size()) pages_.resize(i / kPage + 1);
    std::unique_ptr<Page>& page = pages_[i / kPage];
    if (!page) page = std::make_unique<Page>();
    return (*page)[i % kPage];
  }
  /// All places written with a score of at least `least` (>= 1), in the order of their indices.
  [[nodiscard]] std::vector<Place> listed(int least) const;

 private:
  static constexpr std::size_t kPage = 32;
  using Page = std::array<Place, kPage>;

  std::vector<std::unique_ptr<Page>> pages_;
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
  /// True if a tile of this size, whose first cell is a multiple of it, lies in one bin, so that
  /// its best place is the only one that counts.
  [[nodiscard]] bool holds_tiles(int columns, int rows) const {
    return size_.cells % columns == 0 && size_.cells % rows == 0;
  }
  /// The list, best first.
  [[nodiscard]] std::vector<Place> list() const;

 private:
  void raise_threshold(int before, int now);

  BinSize size_;
  int columns_, rows_, count_;
  SparsePlaces bins_;               ///< The best place of every bin; one without a score is empty.
  std::vector<int> bins_of_score_;  ///< Number of bins with this best score.
  int threshold_ = 1;
  int bins_above_ = 0;  ///< Number of bins above the threshold.
};

}  // namespace castaway::localization
