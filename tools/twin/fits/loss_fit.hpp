/// Fits the share of lost returns to a log: beams that report nothing where the map has a wall.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/aligned_log.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// Beams that were lost among those that saw similar walls.
struct LossCell {
  double range_per_max = 0.0;
  double cosine = 1.0;
  double beams = 0.0;
  double lost = 0.0;
};

/// Shares of lost returns as the simulated lidar has them (`sim::lost_share`), with intervals.
struct LossFit {
  Figure dropout;               ///< Everywhere.
  Figure dropout_far;           ///< Besides at the range limit; grows with the square of the range.
  Figure dropout_grazing;       ///< Besides at grazing incidence; grows with 1 - cosine.
  Figure lost;                  ///< Of all beams on straight walls.
  std::size_t beams = 0;        ///< On straight walls within 95 % of the range limit.
  std::vector<LossCell> cells;  ///< Of the whole log.
};

/// Shares that explain the counts best.
struct LossShares {
  double dropout = 0.0;
  double far = 0.0;
  double grazing = 0.0;
};

/// The share that is lost at a cell's range and incidence.
double lost_share(const LossShares& shares, const LossCell& cell);

/// Maximum likelihood of binomial counts.
LossShares fit_loss(const std::vector<LossCell>& cells);

/// Nothing if too few beams hit straight walls.
std::optional<LossFit> fit_loss(const AlignedLog& log);

}  // namespace castaway::testbed
