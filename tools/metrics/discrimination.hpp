/// How well what a localizer says of its output tells right from wrong.
///
/// J. A. Hanley, B. J. McNeil, "The Meaning and Use of the Area under a Receiver Operating
/// Characteristic (ROC) Curve", Radiology 143, 1982: the area is the probability that a right
/// output scores above a wrong one (Mann and Whitney's U over the number of pairs).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tools/metrics/run_rows.hpp"

namespace castaway::testbed {

/// An output's score and whether the output is right.
struct ScoredOutput {
  double score = 0.0;  ///< Higher: more likely right.
  bool right = false;
};

/// Area under the ROC curve in [0, 1]: the share of pairs of a right and a wrong output in which
/// the right one scores higher, ties counted half. Nothing without outputs of both kinds.
std::optional<double> roc_area(std::vector<ScoredOutput> outputs);

/// The ROC curve: (share of the wrong ones passed, share of the right ones passed) as the threshold
/// falls, from (0, 0) to (1, 1). Empty without outputs of both kinds.
std::vector<std::pair<double, double>> roc_curve(std::vector<ScoredOutput> outputs);

/// Pearson's correlation of pairs; nothing where one of the two does not vary.
std::optional<double> correlation(const std::vector<std::pair<double, double>>& pairs);

/// Areas of the three scores that an output comes with. Right: position error below 0.5 m.
struct Discrimination {
  std::int64_t right = 0;
  std::int64_t wrong = 0;
  std::optional<double> quality;      ///< Of the quality.
  std::optional<double> probability;  ///< Of the stated probability.
  std::optional<double> covariance;   ///< Of minus the root mean variance of x and y.
};

/// Position error from which on an output is wrong. [m]
inline constexpr double kWrongFrom = 0.5;

/// Over the rows with truth and estimate.
Discrimination discrimination_of(const std::vector<MetricRow>& rows);

}  // namespace castaway::testbed
