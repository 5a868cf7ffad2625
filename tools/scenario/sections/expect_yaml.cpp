#include "tools/scenario/sections/expect_yaml.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/run/metrics/metric_paths.hpp"
#include "xacro/files/nearest_name.hpp"

namespace castaway::testbed {
namespace {

Expectation read_expectation(const std::string& metric, YamlReader value) {
  Expectation expectation;
  expectation.metric = metric;
  if (!value.is_map()) {
    expectation.condition = parse_condition(value.as<std::string>());
    return expectation;
  }
  expectation.condition = parse_condition(value.require<std::string>("is"));
  expectation.over = parse_seed_rule(value.get("for", "all seeds"));
  return expectation;
}

}  // namespace

void require_known_metric(const std::string& metric, const std::vector<std::string>& localizers) {
  const std::vector<std::string> known = known_metrics(localizers);
  if (std::find(known.begin(), known.end(), metric) != known.end()) return;
  throw std::invalid_argument(fmt::format("unknown metric '{}'; did you mean '{}'?", metric,
                                          nearest_name(metric, known).value_or("")));
}

std::vector<Expectation> read_expectations(YamlReader& root,
                                           const std::vector<std::string>& localizers) {
  std::vector<Expectation> expectations;
  if (!root.has("expect")) return expectations;
  for (auto& [metric, value] : root.child("expect").entries()) {
    try {
      require_known_metric(metric, localizers);
      expectations.push_back(read_expectation(metric, value));
    } catch (const std::invalid_argument& error) {
      value.fail(error.what());
    }
  }
  return expectations;
}

}  // namespace castaway::testbed
