#include "tools/scenario/sections/name_yaml.hpp"

#include <fmt/format.h>

#include "tools/base/output/file_name.hpp"

namespace castaway::testbed {

void require_name(const YamlReader& reader, const std::string& key, const std::string& name) {
  const std::string trouble = file_name_error(name);
  if (!trouble.empty()) reader.fail(fmt::format("{} '{}' {}", key, name, trouble));
}

std::string get_name(YamlReader& reader, const std::string& key, const std::string& fallback) {
  const auto found = reader.find(key);
  if (!found) return reader.get(key, file_name_of(fallback));
  auto name = found->as<std::string>();
  require_name(*found, key, name);
  return name;
}

}  // namespace castaway::testbed
