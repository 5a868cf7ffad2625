/// Checks runs against expectations.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/expectation.hpp"
#include "tools/run/metrics/metric_paths.hpp"

namespace castaway::testbed {

/// A finished run to be checked.
struct JudgedRun {
  std::uint64_t seed = 0;
  std::filesystem::path folder;
  MetricTable metrics;
  double wall_s = 0.0;  ///< [s] Wall time of the run, for reports.
};

/// One expectation checked against one run, or against the aggregate of several.
struct Check {
  Expectation expectation;
  std::optional<std::uint64_t> seed;  ///< Seed of the run; nothing for an aggregate.
  std::optional<double> value;        ///< Nothing if there was nothing to measure; the expectation
                                      ///< is then not met.
  bool met = false;
  std::filesystem::path folder;  ///< The run to look at; for an aggregate, the run that is farthest
                                 ///< off.
  double wall_s = 0.0;           ///< [s] Wall time of the run, or the sum over all runs.
};

/// Checks every expectation, for each seed or for the aggregate, as its rule says. Runs without a
/// value are excluded from an aggregate.
std::vector<Check> judge(const std::vector<Expectation>& expectations,
                         const std::vector<JudgedRun>& runs);

/// "mh_amcl.recovery.success is 0.667, expected >= 1, missed by 0.333 (seed 3), see FOLDER".
std::string describe(const Check& check);

}  // namespace castaway::testbed
