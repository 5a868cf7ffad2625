/// A curve that is thinned while it is read, so that a day's run needs no more memory than an
/// hour's.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// Collects rows. Once there are more than `most`, adjacent pairs are merged into the row with the
/// larger position error, so that peaks are kept. Later rows are merged to the same density.
class ThinnedCurve {
 public:
  explicit ThinnedCurve(std::size_t most) : most_(most) {}

  void add(const ReportRow& row);
  /// The rows kept, in their original order.
  [[nodiscard]] std::vector<ReportRow> take();

 private:
  void halve();

  std::size_t most_;
  std::size_t stride_ = 1;  ///< Number of input rows per kept row.
  std::size_t open_ = 0;    ///< Number of input rows in the last kept row so far.
  std::vector<ReportRow> rows_;
};

}  // namespace castaway::testbed
