/// Output about expectations: text and JUnit.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/base/formats/junit.hpp"
#include "tools/run/metrics/verdict.hpp"

namespace castaway::testbed {

/// Reads summary.json and timing.json of a finished run.
JudgedRun load_judged_run(const std::filesystem::path& run_folder);

/// A case of a JUnit report for each check.
std::vector<JunitCase> junit_cases(const std::string& scenario, const std::vector<Check>& checks);

/// The case of a run itself: an error if it failed or is void.
JunitCase run_case(const std::string& scenario, std::uint64_t seed, double wall_s,
                   std::optional<std::string> error);

/// How many expectations are met; a line for each that is not. Empty without checks.
std::string describe_checks(const std::vector<Check>& checks);

/// kDone, or kExpectationNotMet if any check is not met.
int exit_code_of(const std::vector<Check>& checks);

}  // namespace castaway::testbed
