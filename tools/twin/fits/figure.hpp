/// Figures fitted to a log, with intervals by the jackknife over blocks of time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// A fitted value with its 95 % interval.
struct Figure {
  double value = 0.0;
  Interval interval;
};

/// A figure whose interval also holds an independent error of this standard deviation: what the
/// model itself is wrong by, which no part of the log shows.
Figure widen(const Figure& figure, double sigma);

/// Items of a log in blocks of successive items, of which one can be left out.
class Blocks {
 public:
  static constexpr std::size_t kCount = 12;  ///< Number of blocks.

  explicit Blocks(std::size_t items) : items_(items) {}

  /// True if item `index` is not in the block that is left out; nothing is left out of `kCount`.
  [[nodiscard]] bool keeps(std::size_t index, std::size_t left_out) const {
    return index * kCount / items_ != left_out;
  }
  [[nodiscard]] std::size_t items() const { return items_; }

 private:
  std::size_t items_;
};

/// Fits several values to a log without one block, or to the whole log (`Blocks::kCount`).
using BlockFit = std::function<std::vector<double>(std::size_t left_out)>;

/// The values of the whole log with 95 % intervals by the delete-a-group jackknife.
///
/// J. W. Tukey, "Bias and confidence in not quite large samples", Annals of Mathematical Statistics
/// 29, 1958; P. S. Kott, "The delete-a-group jackknife", Journal of Official Statistics 17, 2001.
/// The intervals take t's quantile with `Blocks::kCount` - 1 degrees of freedom.
std::vector<Figure> jackknife(const BlockFit& fit);

}  // namespace castaway::testbed
