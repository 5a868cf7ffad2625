/// Names in YAML that become path components and must not be paths themselves.
#pragma once

#include <string>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Fails at `reader`, naming `key`, unless `name` is a valid file name.
void require_name(const YamlReader& reader, const std::string& key, const std::string& name);

/// Reads the value of `key`, or `fallback`; fails as `require_name` does.
std::string get_name(YamlReader& reader, const std::string& key, const std::string& fallback);

}  // namespace castaway::testbed
