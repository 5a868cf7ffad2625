/// Converts a part of a YAML document to JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// Scalars become null, true or false, numbers and texts as in YAML's core schema. Quotes in the
/// YAML text do not count: "12" is a number.
nlohmann::ordered_json yaml_json(const YamlNode& node);

}  // namespace castaway::testbed
