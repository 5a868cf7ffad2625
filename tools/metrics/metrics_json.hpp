/// Metrics as summary.json shows them.
#pragma once

#include <nlohmann/json.hpp>

#include "tools/metrics/localizer_metrics.hpp"

namespace castaway::testbed {

/// The entry of one localizer; keys in the order of the documented format.
nlohmann::ordered_json to_json(const LocalizerMetrics& metrics);

}  // namespace castaway::testbed
