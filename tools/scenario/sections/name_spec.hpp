/// Names in YAML that become parts of paths: never a path themselves.
#pragma once

#include <string>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Fails at `reader`, naming `key`, unless `name` can name a file.
void require_name(const YamlReader& reader, const std::string& key, const std::string& name);

/// The value of `key`, or `fallback`; fails as `require_name` does.
std::string get_name(YamlReader& reader, const std::string& key, const std::string& fallback);

}  // namespace castaway::testbed
