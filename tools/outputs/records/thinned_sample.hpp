/// A sample of bounded size, for runs of any length.
#pragma once

#include <cstddef>
#include <vector>

namespace castaway::testbed {

/// Accumulates numbers. Once there are more than `most`, every second one is dropped, and later
/// numbers are thinned to the same density. Count, mean and maximum remain exact.
class ThinnedSample {
 public:
  explicit ThinnedSample(std::size_t most = 100000) : most_(most) {}

  void add(double value);
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double mean() const { return sum_ / static_cast<double>(count_); }
  [[nodiscard]] double max() const { return max_; }
  /// The values kept, in their original order.
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  std::size_t most_;
  std::size_t stride_ = 1;
  std::size_t count_ = 0;
  double sum_ = 0.0;
  double max_ = 0.0;
  std::vector<double> values_;
};

}  // namespace castaway::testbed
