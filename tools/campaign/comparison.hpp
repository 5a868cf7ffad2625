/// Two sets of runs held against each other, pair by pair.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/metrics/metric_paths.hpp"
#include "tools/metrics/statistics/statistics.hpp"

namespace castaway::testbed {

/// A finished run, as a comparison sees it.
struct ComparedRun {
  std::filesystem::path folder;
  std::string scenario;  ///< Its name.
  std::uint64_t seed = 0;
  int metrics_version = 0;
  std::vector<std::string> localizers;
  MetricTable metrics;
  bool is_void = false;  ///< See tools/metrics/void_run.hpp.
};

/// The run of `folder`, or all runs below it, by folder. Throws std::runtime_error if there is
/// none.
std::vector<ComparedRun> find_runs(const std::filesystem::path& folder);

/// One metric over the pairs that have it in both.
struct MetricComparison {
  std::string metric;
  std::size_t pairs = 0;
  double baseline = 0.0;             ///< Mean.
  double other = 0.0;                ///< Mean.
  double difference = 0.0;           ///< Mean of other - baseline.
  std::optional<Interval> interval;  ///< 95 %, bootstrap over the pairs; nothing for one pair.
  bool more_is_better = false;
  bool clock = false;  ///< Of this machine's clock: shown, never judged.
  /// That chance alone makes such a difference, corrected for the number of metrics compared;
  /// nothing for a clock.
  std::optional<double> p_value{};

  /// 1: better, -1: worse, both at a level of 0.05 over all metrics together; 0: neither.
  [[nodiscard]] int verdict() const;
};

/// What came of it.
struct Comparison {
  std::filesystem::path baseline;
  std::filesystem::path other;
  std::size_t pairs = 0;
  std::size_t unpaired = 0;  ///< Runs of either side without a counterpart, which are left out.
  std::size_t voids = 0;     ///< Void runs of either side, which are left out.
  std::vector<MetricComparison> metrics;
};

/// Pairs runs by scenario and seed; of several that share both, those of the same conditions.
/// Throws std::invalid_argument, one line that says what differs: metrics of two versions, no
/// common scenario, seed or localizer, or a scenario that says something else than its namesake
/// besides localizers, outputs and expectations.
Comparison compare_runs(const std::filesystem::path& baseline, const std::filesystem::path& other);

/// As `castaway compare --json` prints it.
nlohmann::ordered_json to_json(const Comparison& comparison);

}  // namespace castaway::testbed
