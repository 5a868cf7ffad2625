/// Tables of a prediction, for terminal and page, and its JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/batch/compare/experiment_table.hpp"
#include "tools/twin/prediction/agreement.hpp"
#include "tools/twin/prediction/log_prediction.hpp"

namespace castaway::testbed {

/// A row for each log and localizer: success, median time to recovery, tracking error, and share of
/// scans that are wrong without the alarm, each on the log and in the twin.
TextTable results_table(const std::vector<PredictionRow>& rows);

/// A row for each localizer: mean success over logs, and how far the twins are off.
TextTable agreement_table(const std::vector<PredictionRow>& rows);

/// Kendall's tau with its interval, in a sentence.
std::string agreement_sentence(const std::vector<PredictionRow>& rows);

/// What `castaway twin --json` prints.
nlohmann::ordered_json to_json(const std::vector<PredictionRow>& rows,
                               const std::vector<DifferingPlace>& places);

}  // namespace castaway::testbed
