/// The scenario that a specification of many runs starts from.
#pragma once

#include <filesystem>
#include <string>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// A scenario as written, before it is read.
struct BaseScenario {
  YamlNode scenario;
  std::filesystem::path folder;  ///< Where its relative paths start.
};

/// Reads the key `scenario`: a shipped one, a path, or the scenario itself as a map; without it, an
/// empty one. `folder`: of the specification. Throws std::runtime_error naming file and line.
BaseScenario read_base_scenario(YamlReader& root, const std::filesystem::path& folder);

/// Removes a key from a map.
void drop_key(YamlNode& map, const std::string& key);

}  // namespace castaway::testbed
