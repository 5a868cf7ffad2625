/// Predictions for several logs, several at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/twin/prediction/log_prediction.hpp"

namespace castaway::testbed {

/// The names of logs, which name their twins: those of their folders. Throws std::runtime_error if
/// two have one name.
std::vector<std::string> names_of_logs(const std::vector<std::string>& folders);

/// Predictions for all logs, in their order, each as a trial of `run`; none where one has no text.
/// `folders`: as of `load_recorded_place`. The twins are written to `<out>/<log>`. Throws
/// std::runtime_error if two logs have one name, and as `run` and `predict_log` do.
std::vector<LogPrediction> predict_logs(const std::vector<std::string>& folders,
                                        const std::vector<LocalizerSpec>& localizers,
                                        const PredictionConfig& config,
                                        const std::filesystem::path& out, const TrialRunner& run);

}  // namespace castaway::testbed
