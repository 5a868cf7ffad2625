/// Figures of summaries as text for tables.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// A number times `factor`, or "-" if there is none. `format` is fmt's: "{:.2f} s".
std::string figure_text(const nlohmann::ordered_json& value, const char* format,
                        double factor = 1.0);
std::string figure_text(const std::optional<double>& value, const char* format);

/// " [low, high]" of an array of two numbers times `factor`; nothing if it is not an array.
std::string interval_text(const nlohmann::ordered_json& ends, const char* format,
                          double factor = 1.0);

}  // namespace castaway::testbed
