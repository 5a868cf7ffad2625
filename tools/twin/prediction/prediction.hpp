/// How well a twin predicts what localizers do on its log.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/batch/evaluate/evaluation.hpp"

namespace castaway::testbed {

/// A log, and the same log as its twin measured it.
struct TwinPlaces {
  RecordedPlace log;
  std::vector<Frames> replays;  ///< With other noise and other people each.
};

/// A start or a kidnap, on the log and in its twin.
struct PredictedTrial {
  bool kidnap = false;
  int index = 0;           ///< Among the starts or the kidnaps.
  bool recovered = false;  ///< On the log.
  double predicted = 0.0;  ///< Share of the twin's replays in which it recovered.
};

/// Results of one localizer on a log and in its twin, where they are the sum over all replays.
struct PredictionRow {
  EvaluationRow log;
  EvaluationRow twin;
  std::vector<PredictedTrial> trials;
};

/// Evaluates one localizer on both. Errors of tracking in the twin are means over the replays.
/// Throws as `evaluate`.
PredictionRow predict(
    const TwinPlaces& places, const LocalizerSpec& localizer, const EvaluationConfig& config,
    const std::function<void()>& on_trial = [] {});

/// Share of the starts and kidnaps that end right, in [0, 1]; 0 without trials.
double success_of(const EvaluationRow& row);

}  // namespace castaway::testbed
