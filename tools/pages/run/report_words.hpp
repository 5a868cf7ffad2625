/// Describes the results of a run in sentences.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// One or two sentences about a localizer, as HTML. `name` is a key of `summary["localizers"]`.
std::string describe_localizer(const RunFolder& run, const std::string& name);

/// "Scenario lab-kidnap, world lab, robot waffle, seed 1: 120 s, 41.2 m, 3 kidnaps, no collision."
std::string describe_run(const RunFolder& run);

/// The number at a JSON pointer of the summary; nothing if it is null or missing.
std::optional<double> figure_at(const nlohmann::ordered_json& json, const std::string& pointer);

}  // namespace castaway::testbed
