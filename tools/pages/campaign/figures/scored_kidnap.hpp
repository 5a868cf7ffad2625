/// Kidnaps of a cell as the page counts them.
#pragma once

#include <vector>

#include "tools/batch/campaign/cell_row.hpp"

namespace castaway::testbed {

/// A kidnap or unknown start that counts.
struct ScoredKidnap {
  CellKidnap kidnap;
  int number = 0;  ///< Among those of its localizer, from 0 on, those that do not count included.
  /// [s] To the recovery or, without one, to the next kidnap or the end of the run.
  double lost_s = 0.0;
};

/// The scored kidnaps of a localizer in a cell, in their order.
std::vector<ScoredKidnap> scored_kidnaps(const CellRow& row, const std::string& localizer);

}  // namespace castaway::testbed
