#include "tools/scenario/base_scenario.hpp"

#include <stdexcept>

#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

std::filesystem::path find_base(const YamlReader& value, const std::filesystem::path& folder) {
  try {
    return find_scenario(value.as<std::string>(), folder);
  } catch (const std::runtime_error& error) {
    value.fail(error.what());
  }
}

}  // namespace

BaseScenario read_base_scenario(YamlReader& root, const std::filesystem::path& folder) {
  const auto value = root.find("scenario");
  if (!value) return {parse_yaml("{}", "scenario"), folder};
  if (value->is_map()) return {value->raw(), folder};
  const std::filesystem::path file = find_base(*value, folder);
  YamlDocument document = YamlDocument::load(file);
  return {document.root().raw(), file.parent_path()};
}

void drop_key(YamlNode& map, const std::string& key) {
  map.entries.remove_if([&](const YamlEntry& entry) { return entry.key == key; });
}

}  // namespace castaway::testbed
