/// Predictions for several logs, several at once.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/twin/prediction/log_prediction.hpp"

namespace castaway::testbed {

/// Predictions for all logs, in their order. `folders`: as of `load_recorded_place`; `workers` logs
/// are worked on at a time, or as many trials of a single log. The twins are written to
/// `<out>/<log>`. `on_log` is called after each log with its name. Throws std::runtime_error if two
/// logs have one name, or a log cannot be used.
std::vector<LogPrediction> predict_logs(const std::vector<std::string>& folders,
                                        const std::vector<LocalizerSpec>& localizers,
                                        const PredictionConfig& config,
                                        const std::filesystem::path& out,
                                        const std::function<void(const std::string&)>& on_log);

}  // namespace castaway::testbed
