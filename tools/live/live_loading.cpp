#include "tools/live/live_loading.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

bool has_ending(const std::filesystem::path& file, std::string_view ending) {
  return file.filename().string().ends_with(ending);
}

void remove_key(YamlNode& map, const std::string& key) {
  map.entries.remove_if([&](const YamlEntry& entry) { return entry.key == key; });
}

void replace_value(YamlNode& map, const std::string& key, YamlNode value) {
  remove_key(map, key);
  map.entries.push_back({key, std::move(value)});
}

/// The map {key: value}.
YamlNode yaml_pair(const std::string& key, const std::string& value) {
  YamlNode map;
  map.kind = YamlNode::Kind::kMap;
  map.entries.push_back({key, yaml_scalar(value)});
  return map;
}

/// Its localizers were accepted at the command line.
LoadedScenario read_again(const YamlNode& root, const std::string& name) {
  return read_scenario(YamlDocument(root), ".", name, FilePrograms::kAllowed);
}

/// Its file without events, expectations and the places of its world.
YamlNode without_places(const LoadedScenario& scenario) {
  YamlNode root = parse_yaml(scenario.effective, "scenario");
  for (const char* key : {"name", "events", "expect", "start", "drive"}) remove_key(root, key);
  root.entries.push_back({"start", yaml_pair("random", "true")});
  root.entries.push_back({"drive", yaml_pair("route", "random")});
  return root;
}

}  // namespace

LoadedScenario in_world(const LoadedScenario& scenario, const std::filesystem::path& file) {
  YamlNode root = without_places(scenario);
  replace_value(root, "world", yaml_scalar(std::filesystem::absolute(file).string()));
  return read_again(root, file.stem().string());
}

LoadedScenario with_robot(const LoadedScenario& scenario, const std::filesystem::path& file) {
  YamlNode root = without_places(scenario);
  replace_value(root, "robot", yaml_scalar(std::filesystem::absolute(file).string()));
  for (const char* key : {"lidar", "lidars", "odometry"}) remove_key(root, key);
  return read_again(root, scenario.scenario.name);
}

LoadedScenario with_file(const LoadedScenario& scenario, const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw std::runtime_error("there is no file " + file.filename().string() + "; drop it again");
  }
  for (const char* ending : {".sdf", ".world", ".yaml", ".yml", ".sdf.xacro", ".world.xacro"}) {
    if (has_ending(file, ending)) return in_world(scenario, file);
  }
  if (has_ending(file, ".urdf") || has_ending(file, ".xacro")) return with_robot(scenario, file);
  throw std::runtime_error("'" + file.filename().string() +
                           "' is no world (.yaml, .sdf, .world) and no robot (.urdf, .xacro)");
}

}  // namespace castaway::testbed
