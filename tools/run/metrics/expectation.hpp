/// Expectations of a run's metrics.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// A condition on a number. Ranges include both ends.
struct Condition {
  enum class Kind : std::uint8_t { kLess, kAtMost, kGreater, kAtLeast, kEqual, kRange };

  Kind kind = Kind::kAtLeast;
  double low = 0.0;   ///< The number compared with, or the lower end of a range.
  double high = 0.0;  ///< Upper end of a range.
};

/// Parses "< 5", "<= 5", "> 5", ">= 5", "== 5" or "1..5". Throws std::invalid_argument with the
/// text and the accepted forms.
Condition parse_condition(const std::string& text);

/// Formats a condition as `parse_condition` reads it.
std::string to_string(const Condition& condition);

/// Whether the value meets the condition; NaN never does.
bool holds(const Condition& condition, double value);

/// Distance of the value from meeting the condition, in its unit; 0 if the condition holds or fails
/// only because of a strict inequality.
double missed_by(const Condition& condition, double value);

/// How the values of several seeds are combined before they are compared.
enum class SeedRule : std::uint8_t { kAllSeeds, kMean, kMedian, kMin, kMax, kP95 };

/// Parses "all seeds", "mean", "median", "min", "max" or "p95". Throws std::invalid_argument.
SeedRule parse_seed_rule(const std::string& text);

/// Formats a rule as `parse_seed_rule` reads it.
std::string to_string(SeedRule rule);

/// Aggregates a non-empty sample; kAllSeeds gives the mean.
double aggregate(SeedRule rule, std::vector<double> values);

/// A metric and the condition that it must meet.
struct Expectation {
  std::string metric;  ///< A path in summary.json, such as "mh_amcl.recovery.success".
  Condition condition;
  SeedRule over = SeedRule::kAllSeeds;
};

/// Parses "mh_amcl.recovery.success >= 1". Throws std::invalid_argument.
Expectation parse_expectation(const std::string& text);

}  // namespace castaway::testbed
