/// What a run is expected to show, and whether it does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// A condition on a number. Both ends of a range belong to it.
struct Condition {
  enum class Kind : std::uint8_t { kLess, kAtMost, kGreater, kAtLeast, kEqual, kRange };

  Kind kind = Kind::kAtLeast;
  double low = 0.0;   ///< The number compared with; of a range its lower end.
  double high = 0.0;  ///< Of a range its upper end.
};

/// Reads "< 5", "<= 5", "> 5", ">= 5", "== 5" or "1..5". Throws std::invalid_argument with the text
/// and what is accepted.
Condition parse_condition(const std::string& text);

/// As it is read: "< 5", "1..5".
std::string to_string(const Condition& condition);

/// Whether the value meets the condition; one that is not a number never does.
bool holds(const Condition& condition, double value);

/// How far the value is from meeting the condition, in its unit; 0 where it holds or misses by the
/// equality alone.
double missed_by(const Condition& condition, double value);

/// What is judged where there are several seeds.
enum class SeedRule : std::uint8_t { kAllSeeds, kMean, kMedian, kMin, kMax, kP95 };

/// Reads "all seeds", "mean", "median", "min", "max" or "p95". Throws std::invalid_argument.
SeedRule parse_seed_rule(const std::string& text);

/// As it is read.
std::string to_string(SeedRule rule);

/// The aggregate of a non-empty sample; of kAllSeeds the mean.
double aggregate(SeedRule rule, std::vector<double> values);

/// A metric and what is expected of it.
struct Expectation {
  std::string metric;  ///< A path of summary.json, "mh_amcl.recovery.success".
  Condition condition;
  SeedRule over = SeedRule::kAllSeeds;
};

/// Reads "mh_amcl.recovery.success >= 1". Throws std::invalid_argument.
Expectation parse_expectation(const std::string& text);

}  // namespace castaway::testbed
