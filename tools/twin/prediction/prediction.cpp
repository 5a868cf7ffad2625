#include "tools/twin/prediction/prediction.hpp"

namespace castaway::testbed {
namespace {

int trials_of(const EvaluationRow& row) { return row.starts.trials + row.kidnaps.trials; }
int recovered_of(const EvaluationRow& row) { return row.starts.recovered + row.kidnaps.recovered; }

/// The starts and kidnaps of a log; what the twin predicts is not set.
std::vector<PredictedTrial> trials_on_log(const EvaluationConfig& config,
                                          const std::vector<EvaluationRow>& rows) {
  std::vector<PredictedTrial> trials;
  for (int i = 0; i < config.starts + config.kidnaps; ++i) {
    const bool kidnap = i >= config.starts;
    trials.push_back({kidnap, kidnap ? i - config.starts : i,
                      recovered_of(rows[static_cast<std::size_t>(i)]) > 0});
  }
  return trials;
}

using TrackingFigure = std::optional<double> EvaluationRow::*;

/// Mean of a figure over the last rows of the replays, which hold tracking. The first recording is
/// the log.
std::optional<double> mean_of_tracking(const std::vector<std::vector<EvaluationRow>>& rows,
                                       TrackingFigure figure) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const std::optional<double>& value = rows[k].back().*figure;
    if (!value) continue;
    sum += *value;
    count += 1.0;
  }
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

PredictionRow predict(const TwinPlaces& places, const LocalizerSpec& localizer,
                      const EvaluationConfig& config, const std::function<void()>& on_trial) {
  std::vector<const Frames*> recordings{&places.log.frames};
  for (const Frames& replay : places.replays) recordings.push_back(&replay);
  const auto rows = evaluate_trials(places.log, recordings, localizer, config, on_trial);
  PredictionRow prediction;
  prediction.log = sum_trials(places.log, localizer, rows.front());
  prediction.trials = trials_on_log(config, rows.front());
  std::vector<EvaluationRow> in_twin;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < prediction.trials.size(); ++i) {
      prediction.trials[i].predicted +=
          recovered_of(rows[k][i]) / static_cast<double>(places.replays.size());
    }
    in_twin.insert(in_twin.end(), rows[k].begin(), rows[k].end());
  }
  prediction.twin = sum_trials(places.log, localizer, in_twin);
  if (config.tracking) {
    for (const TrackingFigure figure :
         {&EvaluationRow::tracking_m, &EvaluationRow::tracking_yaw_rad,
          &EvaluationRow::tracking_no_alarm_m}) {
      prediction.twin.*figure = mean_of_tracking(rows, figure);
    }
  }
  return prediction;
}

double success_of(const EvaluationRow& row) {
  return trials_of(row) > 0 ? static_cast<double>(recovered_of(row)) / trials_of(row) : 0.0;
}

}  // namespace castaway::testbed
