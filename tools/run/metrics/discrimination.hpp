/// How well the scores that a localizer states about its output separate right from wrong outputs.
///
/// J. A. Hanley, B. J. McNeil, "The Meaning and Use of the Area under a Receiver Operating
/// Characteristic (ROC) Curve", Radiology 143, 1982: the area is the probability that a right
/// output scores above a wrong one (Mann and Whitney's U over the number of pairs).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tools/run/metrics/run_rows.hpp"

namespace castaway::testbed {

/// An output's score and whether the output is right.
struct ScoredOutput {
  double score = 0.0;  ///< Higher: more likely right.
  bool right = false;
};

/// Area under the ROC curve in [0, 1]: the share of pairs of a right and a wrong output in which
/// the right one scores higher; ties count half. Nothing unless there are outputs of both kinds.
std::optional<double> roc_area(std::vector<ScoredOutput> outputs);

/// The ROC curve: points (false positive rate, true positive rate) as the threshold falls, from (0,
/// 0) to (1, 1). Empty unless there are outputs of both kinds.
std::vector<std::pair<double, double>> roc_curve(std::vector<ScoredOutput> outputs);

/// Pearson's correlation of pairs; nothing if one of the two is constant.
std::optional<double> correlation(const std::vector<std::pair<double, double>>& pairs);

/// ROC areas of the three scores of an output. Right means a position error below 0.5 m.
struct Discrimination {
  std::int64_t right = 0;
  std::int64_t wrong = 0;
  std::optional<double> quality;      ///< Area for the quality.
  std::optional<double> probability;  ///< Area for the stated probability.
  std::optional<double> covariance;   ///< Area for minus the root mean variance of x and y.
};

/// [m] An output with at least this position error is wrong.
inline constexpr double kWrongFrom = 0.5;

/// Discrimination over the rows that have truth and estimate.
Discrimination discrimination_of(const std::vector<MetricRow>& rows);

}  // namespace castaway::testbed
