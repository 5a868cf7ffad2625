/// The page of a prediction.
#pragma once

#include <string>
#include <vector>

#include "tools/twin/prediction/log_prediction.hpp"

namespace castaway::testbed {

/// A self-contained HTML page: tables, predicted against measured success, and places to look at.
/// Links lead to `twins/<log>/calibration.html`.
std::string render_prediction(const std::vector<PredictionRow>& rows,
                              const std::vector<DifferingPlace>& places);

}  // namespace castaway::testbed
