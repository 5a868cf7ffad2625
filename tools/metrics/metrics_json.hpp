/// Metrics as summary.json shows them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tools/metrics/fault_metrics.hpp"
#include "tools/metrics/localizer_metrics.hpp"

namespace castaway::testbed {

/// A figure with nine digits after the point: far below what is measured, and the same text
/// everywhere.
nlohmann::ordered_json json_figure(double value);

/// Brier score and reliability diagram.
nlohmann::ordered_json to_json(const Calibration& calibration);

/// What a fault of a sensor did to a localizer.
nlohmann::ordered_json to_json(const FaultMetrics& metrics);

/// The entry of one localizer; keys in the order of the documented format.
nlohmann::ordered_json to_json(const LocalizerMetrics& metrics);

}  // namespace castaway::testbed
