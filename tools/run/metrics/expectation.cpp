#include "tools/run/metrics/expectation.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

using ConditionKind = Condition::Kind;

// Longer operators first, since "<=" begins with "<".
constexpr std::array<std::pair<std::string_view, ConditionKind>, 5> kOperators{
    {{"<=", ConditionKind::kAtMost},
     {">=", ConditionKind::kAtLeast},
     {"==", ConditionKind::kEqual},
     {"<", ConditionKind::kLess},
     {">", ConditionKind::kGreater}}};

constexpr std::array<std::pair<std::string_view, SeedRule>, 6> kRules{
    {{"all seeds", SeedRule::kAllSeeds},
     {"mean", SeedRule::kMean},
     {"median", SeedRule::kMedian},
     {"min", SeedRule::kMin},
     {"max", SeedRule::kMax},
     {"p95", SeedRule::kP95}}};

std::string_view trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<double> number(std::string_view text) {
  const std::string_view digits = trim(text);
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<Condition> parse_range(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto low = number(text.substr(0, dots));
  const auto high = number(text.substr(dots + 2));
  if (!low || !high || *low > *high) return std::nullopt;
  return Condition{ConditionKind::kRange, *low, *high};
}

std::optional<Condition> parse_comparison(std::string_view text) {
  for (const auto& [symbol, kind] : kOperators) {
    if (!text.starts_with(symbol)) continue;
    const auto value = number(text.substr(symbol.size()));
    return value ? std::optional(Condition{kind, *value, *value}) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

Condition parse_condition(const std::string& text) {
  const std::string_view body = trim(text);
  if (const auto range = parse_range(body)) return *range;
  if (const auto comparison = parse_comparison(body)) return *comparison;
  throw std::invalid_argument(fmt::format(
      "'{}' is no condition; give an operator (<, <=, >, >=, ==) and a number, \"< 5\", "
      "or a range, \"0..7\"",
      text));
}

std::string to_string(const Condition& condition) {
  if (condition.kind == ConditionKind::kRange)
    return fmt::format("{}..{}", condition.low, condition.high);
  const auto* const found =
      std::find_if(kOperators.begin(), kOperators.end(),
                   [&](const auto& entry) { return entry.second == condition.kind; });
  return fmt::format("{} {}", found->first, condition.low);
}

bool holds(const Condition& condition, double value) {
  switch (condition.kind) {
    case ConditionKind::kLess:
      return value < condition.low;
    case ConditionKind::kAtMost:
      return value <= condition.low;
    case ConditionKind::kGreater:
      return value > condition.low;
    case ConditionKind::kAtLeast:
      return value >= condition.low;
    case ConditionKind::kEqual:
      return value == condition.low;
    case ConditionKind::kRange:
      return value >= condition.low && value <= condition.high;
  }
  return false;
}

double missed_by(const Condition& condition, double value) {
  if (holds(condition, value)) return 0.0;
  if (condition.kind == ConditionKind::kRange && value > condition.high)
    return value - condition.high;
  return std::abs(value - condition.low);
}

SeedRule parse_seed_rule(const std::string& text) {
  for (const auto& [name, rule] : kRules) {
    if (name == text) return rule;
  }
  throw std::invalid_argument(fmt::format(
      "'{}' is not known; give 'all seeds', 'mean', 'median', 'min', 'max' or 'p95'", text));
}

std::string to_string(SeedRule rule) {
  const auto* const found = std::find_if(kRules.begin(), kRules.end(),
                                         [&](const auto& entry) { return entry.second == rule; });
  return std::string(found->first);
}

double aggregate(SeedRule rule, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  if (rule == SeedRule::kMin) return values.front();
  const Statistics figures = *statistics(std::move(values));
  if (rule == SeedRule::kMedian) return figures.median;
  if (rule == SeedRule::kMax) return figures.max;
  return rule == SeedRule::kP95 ? figures.p95 : figures.mean;
}

Expectation parse_expectation(const std::string& text) {
  const std::string_view body = trim(text);
  const std::size_t space = body.find_first_of(" <>=");
  if (space == std::string_view::npos || space == 0) {
    throw std::invalid_argument(
        fmt::format("'{}' is no expectation; give a metric and a condition, "
                    "\"mh_amcl.recovery.success >= 1\"",
                    text));
  }
  return {std::string(body.substr(0, space)), parse_condition(std::string(body.substr(space))),
          SeedRule::kAllSeeds};
}

}  // namespace castaway::testbed
