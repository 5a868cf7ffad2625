/// Runs the twin of a log, to compare both.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/twin/log_fit.hpp"

namespace castaway::testbed {

/// The frames of a twin, with its true poses. `folder` holds `map.yaml` and `path.tum`; `scenario`
/// is the text of its scenario. Throws as `build_simulation`.
RecordedPlace run_twin(const std::filesystem::path& folder, const std::string& scenario,
                       std::uint64_t seed);

/// The number of people with whom as many moving objects are seen in the twin as in the log, with
/// an interval. Runs the twin with some people, at most three times.
Figure fit_people(const std::filesystem::path& folder, const FittedLog& fitted);

}  // namespace castaway::testbed
