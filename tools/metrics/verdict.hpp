/// Expectations held against runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/metrics/expectation.hpp"
#include "tools/metrics/metric_paths.hpp"

namespace castaway::testbed {

/// A finished run to be judged.
struct JudgedRun {
  std::uint64_t seed = 0;
  std::filesystem::path folder;
  MetricTable metrics;
  double wall_s = 0.0;  ///< [s] That it took, for those who list times.
};

/// One expectation held against one run, or against all of them put together.
struct Check {
  Expectation expectation;
  std::optional<std::uint64_t> seed;  ///< Of the run; nothing: of several put together.
  std::optional<double> value;        ///< Nothing: there was nothing to measure, which is not met.
  bool met = false;
  std::filesystem::path folder;  ///< The run to look at: of several the one furthest off.
  double wall_s = 0.0;           ///< [s] Of the run, or of all.
};

/// Every expectation, for each seed or put together as it says. Runs that have nothing to measure
/// take no part in an aggregate.
std::vector<Check> judge(const std::vector<Expectation>& expectations,
                         const std::vector<JudgedRun>& runs);

/// "mh_amcl.recovery.success is 0.667, expected >= 1, missed by 0.333 (seed 3), see FOLDER".
std::string describe(const Check& check);

}  // namespace castaway::testbed
