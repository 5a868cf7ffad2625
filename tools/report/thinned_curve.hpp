/// Rows of a curve, thinned out while they are read: a day's run fills no more than an hour's.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// Gathers rows. Once there are more than `most`, every two become one: the one of the larger
/// position error, so that peaks stay; all rows that follow are gathered as coarsely.
class ThinnedCurve {
 public:
  explicit ThinnedCurve(std::size_t most) : most_(most) {}

  void add(const ReportRow& row);
  /// What is left of all rows, in their order.
  [[nodiscard]] std::vector<ReportRow> take();

 private:
  void halve();

  std::size_t most_;
  std::size_t stride_ = 1;  ///< Rows that one stands for.
  std::size_t open_ = 0;    ///< Rows that the last one stands for so far.
  std::vector<ReportRow> rows_;
};

}  // namespace castaway::testbed
