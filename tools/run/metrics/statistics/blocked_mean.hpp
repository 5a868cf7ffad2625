/// Mean of a stream of values that are independent between blocks, and not within them.
///
/// Student's interval and test ("The Probable Error of a Mean", Biometrika 6, 1908) with the
/// variance of block totals (K.-Y. Liang, S. L. Zeger, "Longitudinal Data Analysis Using
/// Generalized Linear Models", Biometrika 73, 1986, for a mean) and one degree of freedom less than
/// blocks. With one value a block they are Student's own.
#pragma once

#include <cstdint>
#include <optional>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// Values are not kept. All are in their unit.
class BlockedMean {
 public:
  /// The values of a block are added one after the other.
  void add(double value, std::uint64_t block);

  [[nodiscard]] std::int64_t count() const { return count_; }
  [[nodiscard]] std::int64_t blocks() const { return blocks_; }
  /// 0 without values.
  [[nodiscard]] double mean() const { return mean_; }
  /// 95 %; nothing for fewer than two blocks.
  [[nodiscard]] std::optional<Interval> interval() const;
  /// Two-sided p-value of the mean being 0; 1 for fewer than two blocks.
  [[nodiscard]] double p_value() const;

 private:
  /// Sums over finished blocks of products of a block's total and its count. Totals are of values
  /// less `origin_`, which keeps the sums small.
  struct Products {
    double totals = 0.0;
    double mixed = 0.0;
    double counts = 0.0;

    void add(double total, double count);
  };
  [[nodiscard]] double standard_error() const;

  std::int64_t count_ = 0;
  std::int64_t blocks_ = 0;
  double mean_ = 0.0;
  double origin_ = 0.0;  // The first value.
  Products products_;
  std::uint64_t block_ = 0;  // The last one, with its total and count.
  double block_total_ = 0.0;
  double block_count_ = 0.0;
};

}  // namespace castaway::testbed
