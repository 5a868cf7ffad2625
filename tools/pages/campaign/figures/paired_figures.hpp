/// Two localizers in the same cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/pages/campaign/figures/campaign_series.hpp"
#include "tools/pages/campaign/figures/scored_kidnap.hpp"
#include "tools/run/metrics/statistics/blocked_mean.hpp"
#include "tools/run/metrics/statistics/paired_shares.hpp"

namespace castaway::testbed {

/// Differences of a figure over pairs. Those of one seed are not independent, as its cells have the
/// same places.
class PairedMean {
 public:
  /// The differences of a seed are added one after the other.
  void add(double difference, std::uint64_t seed);
  [[nodiscard]] const BlockedMean& mean() const { return mean_; }
  /// Two-sided, that the mean is 0: the sign-flip test of the seeds' totals for up to 2000 seeds,
  /// Student's for more.
  [[nodiscard]] double p_value(const std::string& stream) const;

 private:
  BlockedMean mean_;
  std::vector<double> totals_;  // Of the first seeds, as many as the sign-flip test takes.
};

/// A localizer of a cell.
struct PairedCell {
  std::size_t series = 0;
  std::uint64_t seed = 1;
  std::vector<ScoredKidnap> kidnaps;
  std::optional<double> tracking_error_m;  ///< [m] Mean of the cell.
};

/// First minus second localizer.
struct PairedFigures {
  std::size_t first = 0;  ///< Index of its series.
  std::size_t second = 0;
  PairedOutcomes recoveries;    ///< Of kidnaps.
  PairedMean success;           ///< The same as 1 and 0, by seed.
  PairedMean recovery_time_s;   ///< [s] Over kidnaps that both recovered from.
  PairedMean time_lost_s;       ///< [s] Over all kidnaps: to the recovery, or else to the end.
  PairedMean tracking_error_m;  ///< [m] Over cells.

  void add(const PairedCell& a, const PairedCell& b);
};

/// All pairs of localizers. Cells are pairs if they differ by the key `localizers` alone, kidnaps
/// if they have the same number, kind and time within such a pair.
class LocalizerPairs {
 public:
  explicit LocalizerPairs(std::size_t series);
  /// Adds all localizers of cells that differ by the key `localizers` alone.
  void add(const std::vector<PairedCell>& cells);
  [[nodiscard]] const std::vector<PairedFigures>& pairs() const { return pairs_; }

 private:
  std::vector<PairedFigures> pairs_;
};

/// A tested difference, as the page lists it.
struct PairedTest {
  std::size_t first = 0;
  std::size_t second = 0;
  std::string figure;
  std::int64_t pairs = 0;
  std::int64_t seeds = 0;  ///< With a pair.
  double difference = 0.0;
  std::optional<Interval> interval;  ///< 95 %
  double p_value = 1.0;              ///< Uncorrected.
  double corrected = 1.0;            ///< Holm's correction over all tests.
  std::string counts;                ///< For shares: how often only one of them succeeded.
};

/// The tests of all pairs of localizers that share a cell.
std::vector<PairedTest> paired_tests(const LocalizerPairs& pairs);

}  // namespace castaway::testbed
