/// How far predictions and results of several localizers on several logs agree.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/statistics/statistics.hpp"
#include "tools/twin/prediction/prediction.hpp"

namespace castaway::testbed {

/// Results of one localizer over all logs. Every log counts the same.
struct LocalizerAgreement {
  std::string localizer;
  double measured = 0.0;   ///< Mean success on the logs, in [0, 1].
  double predicted = 0.0;  ///< Mean success in their twins.
  double apart = 0.0;      ///< Mean over logs of the absolute difference.
  int tracked = 0;         ///< Logs with a tracking error without alarm on both sides,
  int tracked_near = 0;    ///< and those of them where the twin's is within 25 % of the log's.
};

/// In the order of the localizers. `rows`: all localizers of each log.
std::vector<LocalizerAgreement> by_localizer(const std::vector<PredictionRow>& rows);

/// A figure with its 95 % interval, where the sample allows one.
struct BootstrapFigure {
  double value = 0.0;
  std::optional<Interval> interval{};
};

/// Kendall's tau between the rankings of the localizers by mean success, measured and predicted.
/// The interval is a bootstrap over logs and the trials of each; one log has none, since it does
/// not tell how far logs differ. Nothing if all localizers are equal in one of them.
std::optional<BootstrapFigure> rank_agreement(const std::vector<PredictionRow>& rows);

}  // namespace castaway::testbed
