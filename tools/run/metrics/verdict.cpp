#include "tools/run/metrics/verdict.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

std::optional<double> value_of(const JudgedRun& run, const std::string& metric) {
  const auto found = run.metrics.find(metric);
  return found == run.metrics.end() ? std::nullopt : found->second;
}

Check check_of(const Expectation& expectation, const JudgedRun& run) {
  Check check{expectation, run.seed,   value_of(run, expectation.metric),
              false,       run.folder, run.wall_s};
  check.met = check.value && holds(expectation.condition, *check.value);
  return check;
}

/// How far a run is off; infinite if it has no value.
double distance(const Expectation& expectation, const JudgedRun& run) {
  const auto value = value_of(run, expectation.metric);
  return value ? missed_by(expectation.condition, *value) : std::numeric_limits<double>::infinity();
}

Check check_of(const Expectation& expectation, const std::vector<JudgedRun>& runs) {
  Check check{expectation, std::nullopt, std::nullopt, false, {}, 0.0};
  std::vector<double> values;
  for (const JudgedRun& run : runs) {
    check.wall_s += run.wall_s;
    if (const auto value = value_of(run, expectation.metric)) values.push_back(*value);
  }
  const auto worst =
      std::max_element(runs.begin(), runs.end(), [&](const JudgedRun& a, const JudgedRun& b) {
        return distance(expectation, a) < distance(expectation, b);
      });
  if (worst != runs.end()) check.folder = worst->folder;
  if (!values.empty()) check.value = aggregate(expectation.over, std::move(values));
  check.met = check.value && holds(expectation.condition, *check.value);
  return check;
}

}  // namespace

std::vector<Check> judge(const std::vector<Expectation>& expectations,
                         const std::vector<JudgedRun>& runs) {
  std::vector<Check> checks;
  for (const Expectation& expectation : expectations) {
    if (expectation.over == SeedRule::kAllSeeds) {
      for (const JudgedRun& run : runs) checks.push_back(check_of(expectation, run));
    } else {
      checks.push_back(check_of(expectation, runs));
    }
  }
  return checks;
}

std::string describe(const Check& check) {
  const Expectation& expectation = check.expectation;
  const std::string who = check.seed ? fmt::format("seed {}", *check.seed)
                                     : to_string(expectation.over) + " of the seeds";
  const std::string wanted = to_string(expectation.condition);
  if (!check.value) {
    return fmt::format("{} has nothing to measure, expected {} ({}), see {}", expectation.metric,
                       wanted, who, check.folder.string());
  }
  if (check.met)
    return fmt::format("{} is {:.4g}, {} ({})", expectation.metric, *check.value, wanted, who);
  return fmt::format("{} is {:.4g}, expected {}, missed by {:.4g} ({}), see {}", expectation.metric,
                     *check.value, wanted, missed_by(expectation.condition, *check.value), who,
                     check.folder.string());
}

}  // namespace castaway::testbed
