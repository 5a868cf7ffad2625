/// Values as JSON without names, for transfer between processes: every bit of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/run/metrics/calibration.hpp"

namespace castaway::testbed {

/// A number, or text for one that is not finite, which JSON has no number for.
nlohmann::ordered_json packed(double value);
/// Throws nlohmann::json::exception for any other JSON, as do the following ones.
double unpacked_double(const nlohmann::ordered_json& json);

nlohmann::ordered_json packed(const std::optional<double>& value);
std::optional<double> unpacked_number(const nlohmann::ordered_json& json);

nlohmann::ordered_json packed(const Calibration& calibration);
Calibration unpacked_calibration(const nlohmann::ordered_json& json);

/// What a worker answers for a trial: the text of `play`, or that a localizer failed.
std::string packed_trial(const std::function<std::string()>& play);
/// The text. Throws LocalizerFailure if a localizer failed.
std::string unpacked_trial(const std::string& answer);

}  // namespace castaway::testbed
