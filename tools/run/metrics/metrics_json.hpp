/// Metrics as JSON, for summary.json.
#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/metrics/fault_metrics.hpp"
#include "tools/run/metrics/localizer_metrics.hpp"

namespace castaway::testbed {

/// Rounds a number to nine decimal places, which is far finer than any measurement and gives the
/// same text on every platform.
nlohmann::ordered_json json_figure(double value);
/// Likewise; null for nothing.
nlohmann::ordered_json json_figure(const std::optional<double>& value);

/// Brier score and reliability diagram.
nlohmann::ordered_json to_json(const Calibration& calibration);

/// Metrics of a localizer during a sensor fault.
nlohmann::ordered_json to_json(const FaultMetrics& metrics);

/// The entry of one localizer; keys are in the order of the documented format.
nlohmann::ordered_json to_json(const LocalizerMetrics& metrics);

}  // namespace castaway::testbed
