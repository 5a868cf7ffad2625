/// Runs the twin of a log, to compare both.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// The frames of a scenario, given as text, with its true poses. Throws as `build_simulation`.
RecordedPlace run_scenario(const std::string& scenario, std::uint64_t seed);

/// The frames of a twin. `folder` holds what `write_twin_inputs` writes, whatever the current
/// folder holds; `scenario` is the text of its scenario. Throws as `build_simulation`.
RecordedPlace run_twin(const std::filesystem::path& folder, const std::string& scenario,
                       std::uint64_t seed);

/// The number of people with whom as many moving objects are seen in the twin as in the log, with
/// an interval. Runs the twin with some people, at most three times.
Figure fit_people(const std::filesystem::path& folder, const FittedLog& fitted);

/// The mixed pixels of the log beyond what stands between two surfaces in its twin as well. Runs
/// the twin once, with beams that are lines.
std::optional<MixedFit> fit_mixed_beyond(const std::filesystem::path& folder, FittedLog fitted,
                                         int people);

}  // namespace castaway::testbed
