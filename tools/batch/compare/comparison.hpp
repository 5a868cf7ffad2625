/// Paired comparison of two sets of runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/metrics/metric_paths.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// A finished run as input of a comparison.
struct ComparedRun {
  std::filesystem::path folder;
  std::string scenario;  ///< Name of the scenario.
  std::uint64_t seed = 0;
  int metrics_version = 0;
  std::vector<std::string> localizers;
  MetricTable metrics;
  bool is_void = false;  ///< See tools/run/metrics/void_run.hpp.
};

/// Finds the run in `folder`, or all runs below it, sorted by folder. Throws std::runtime_error if
/// there is none.
std::vector<ComparedRun> find_runs(const std::filesystem::path& folder);

/// Comparison of one metric over the pairs in which both runs have it.
struct MetricComparison {
  std::string metric;
  std::size_t pairs = 0;
  double baseline = 0.0;             ///< Mean.
  double other = 0.0;                ///< Mean.
  double difference = 0.0;           ///< Mean of other - baseline.
  std::optional<Interval> interval;  ///< 95 % bootstrap interval over the pairs; nothing for a
                                     ///< single pair.
  bool more_is_better = false;
  bool clock = false;  ///< CPU or wall time of this machine: reported but never tested.
  /// p-value of the difference under the null hypothesis, corrected for the number of metrics
  /// compared. Nothing for a clock.
  std::optional<double> p_value{};
  /// Set if no outcome of so few pairs could be significant: the number of pairs that it takes.
  std::optional<std::size_t> pairs_needed{};

  /// 1: better; -1: worse; 0: not significant at a level of 0.05 over all metrics together.
  [[nodiscard]] int verdict() const;
};

/// Result of a comparison.
struct Comparison {
  std::filesystem::path baseline;
  std::filesystem::path other;
  std::size_t pairs = 0;
  std::size_t unpaired = 0;  ///< Runs of either side without a counterpart; they are excluded.
  std::size_t voids = 0;     ///< Void runs of either side; they are excluded.
  std::vector<MetricComparison> metrics;
};

/// Pairs runs by scenario name and seed; among several candidates, those of the same conditions.
/// Throws std::invalid_argument with one line that names the difference: other metrics versions, no
/// common scenario, seed or localizer, or two scenarios of one name that differ in more than
/// localizers, outputs and expectations.
Comparison compare_runs(const std::filesystem::path& baseline, const std::filesystem::path& other);

/// JSON for `castaway compare --json`.
nlohmann::ordered_json to_json(const Comparison& comparison);

}  // namespace castaway::testbed
