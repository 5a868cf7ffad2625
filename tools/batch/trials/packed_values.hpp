/// Values as JSON without names, for transfer between processes: every bit of them.
#pragma once

#include <optional>

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

}  // namespace castaway::testbed
