/// Results of localizers on logs and in their twins, for tests.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tools/twin/prediction/prediction.hpp"

namespace castaway::testbed {

/// Starts on a log, and shares of a twin's ten replays in which they ended right.
inline PredictionRow prediction_row(const std::string& log, const std::string& localizer,
                                    const std::vector<bool>& recovered,
                                    const std::vector<double>& predicted) {
  constexpr int kReplays = 10;
  PredictionRow row;
  row.log.log = row.twin.log = log;
  row.log.localizer = row.twin.localizer = localizer;
  row.log.starts.trials = static_cast<int>(recovered.size());
  row.twin.starts.trials = kReplays * static_cast<int>(predicted.size());
  for (std::size_t i = 0; i < recovered.size(); ++i) {
    row.log.starts.recovered += recovered[i] ? 1 : 0;
    row.twin.starts.recovered += static_cast<int>(std::lround(kReplays * predicted[i]));
    row.trials.push_back({false, static_cast<int>(i), recovered[i], predicted[i]});
  }
  return row;
}

/// The same with equal results of all trials.
inline PredictionRow equal_trials(const std::string& log, const std::string& localizer,
                                  bool recovered, double predicted) {
  return prediction_row(log, localizer, {recovered, recovered}, {predicted, predicted});
}

inline PredictionRow with_tracking(PredictionRow row, std::optional<double> log_m,
                                   std::optional<double> twin_m) {
  row.log.tracking_no_alarm_m = log_m;
  row.twin.tracking_no_alarm_m = twin_m;
  return row;
}

}  // namespace castaway::testbed
