#include "tools/live/live_loading.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "tools/scenario/files/bag_folder.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

bool has_ending(std::string_view file, std::initializer_list<std::string_view> endings) {
  return std::ranges::any_of(endings, [&](std::string_view end) { return file.ends_with(end); });
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

/// The log with the localizers of what is played now, and the map `map`; empty: that of the log
/// that is played now. It is played on the 3-D map of that log, too; a CARMEN log with its height
/// of the lidar.
ReplaySession with_log(const LiveSetup& setup, const std::filesystem::path& log,
                       const std::string& map) {
  const YamlNode now =
      setup.session ? setup.session->tree : parse_yaml(setup.scenario.effective, "scenario");
  YamlNode root;
  root.kind = YamlNode::Kind::kMap;
  root.entries.push_back({"log", yaml_scalar(std::filesystem::absolute(log).string())});
  if (!map.empty()) {
    root.entries.push_back({"map", yaml_scalar(std::filesystem::absolute(map).string())});
  } else if (setup.session && !is_bag(log)) {
    root.entries.push_back({"map", yaml_scalar(setup.session->map)});
  }
  if (setup.session && !setup.session->map3d.empty()) {
    root.entries.push_back({"map3d", yaml_scalar(setup.session->map3d)});
    const auto& height = setup.session->base_height;
    if (height && !is_bag(log)) root.entries.push_back({"base_height", write_yaml(*height)});
  }
  root.entries.push_back({"localizers", *now.find("localizers")});
  ReplaySession session = read_session(YamlDocument(std::move(root)), {{}, FilePrograms::kAllowed});
  if (session.map.empty() && session.map3d.empty() && !is_bag(log)) {
    throw std::runtime_error("a CARMEN log holds no map: drop a .yaml with its picture beside it");
  }
  return session;
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

LiveSetup with_file(const LiveSetup& setup, const std::string& file, const std::string& map) {
  const std::filesystem::path path = setup.files / file;
  for (const std::string& name : {file, map}) {
    if (name.empty() || std::filesystem::is_regular_file(setup.files / name)) continue;
    throw std::runtime_error("there is no file " + name + "; drop it again");
  }
  LiveSetup changed = setup;
  if (has_ending(file, {".log", ".log.gz", ".carmen", ".carmen.gz", ".mcap"})) {
    changed.session = with_log(setup, path, map.empty() ? "" : (setup.files / map).string());
    return changed;
  }
  changed.session.reset();
  if (has_ending(file, {".sdf", ".world", ".yaml", ".yml", ".sdf.xacro", ".world.xacro"})) {
    changed.scenario = in_world(setup.scenario, path);
  } else if (has_ending(file, {".urdf", ".xacro"})) {
    changed.scenario = with_robot(setup.scenario, path);
  } else {
    throw std::runtime_error("'" + file +
                             "' is no world (.yaml, .sdf, .world), no robot (.urdf, .xacro) and no "
                             "log (.log, .log.gz, .mcap)");
  }
  return changed;
}

}  // namespace castaway::testbed
