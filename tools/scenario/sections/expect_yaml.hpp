/// Expectations as YAML.
#pragma once

#include <string>
#include <vector>

#include "tools/run/metrics/expectation.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads the map under `expect`: a metric with a condition `"< 5"` or `{is: "< 5", for: mean}`. A
/// metric that a run with these localizers cannot have is an error that names the nearest one.
std::vector<Expectation> read_expectations(YamlReader& root,
                                           const std::vector<std::string>& localizers);

/// Throws std::invalid_argument naming the nearest metric if a run with these localizers cannot
/// have this one.
void require_known_metric(const std::string& metric, const std::vector<std::string>& localizers);

}  // namespace castaway::testbed
