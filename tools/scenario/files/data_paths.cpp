#include "tools/scenario/files/data_paths.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> folders_in(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(path, none)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The data folder of the program: `share/castaway` next to its folder when installed, or inside it
/// in a build tree, which links to the source tree's data.
fs::path beside_program() {
  std::error_code none;
  const fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const fs::path& share : {folder.parent_path() / "share", folder / "share"}) {
    const fs::path worlds = fs::canonical(share / "castaway/worlds", none);
    if (!none) return worlds.parent_path();
  }
  return folder.parent_path() / "share/castaway";
}

fs::path& shipped_data() {
  static fs::path folder = beside_program();
  return folder;
}

/// Finds `<data>/<kind>s/<text>/<one of files>`.
fs::path find(const std::string& kind, const std::string& text, const fs::path& base,
              const std::vector<std::string>& files) {
  const fs::path shipped = data_root() / (kind + "s");
  for (const fs::path& candidate : {fs::path(text), base / text, shipped / text}) {
    if (text.empty()) break;
    if (fs::is_regular_file(candidate)) return candidate;
    for (const std::string& file : files) {
      if (fs::is_regular_file(candidate / file)) return candidate / file;
    }
  }
  throw std::runtime_error(fmt::format("{} '{}' not found: give a path, or one of: {}", kind, text,
                                       fmt::join(folders_in(shipped), ", ")));
}

fs::path shipped_scenarios(const fs::path& world) {
  return data_root() / "worlds" / world / "scenarios";
}

}  // namespace

fs::path data_root() {
  const char* named = std::getenv("CASTAWAY_DATA");
  const fs::path root = named != nullptr ? fs::path(named) : shipped_data();
  std::error_code none;
  if (fs::is_directory(root / "worlds", none)) return root;
  throw std::runtime_error(fmt::format(
      "{}: holds no worlds; set CASTAWAY_DATA to the folder that holds worlds, robots and lidars",
      root.string()));
}

void set_shipped_data(const fs::path& folder) { shipped_data() = folder; }

fs::path find_world(const std::string& text, const fs::path& base) {
  return find("world", text, base, {"world.yaml"});
}

fs::path find_scenario(const std::string& text, const fs::path& base) {
  const fs::path named(text);
  const fs::path shipped =
      shipped_scenarios(named.parent_path()) / (named.filename().string() + ".yaml");
  for (const fs::path& candidate : {named, base / named, shipped}) {
    std::error_code none;
    if (fs::is_directory(candidate, none) && !fs::is_regular_file(shipped, none)) {
      throw std::runtime_error(candidate.string() +
                               ": is a folder; give a scenario's file (YAML) or its name");
    }
    if (fs::exists(candidate, none) && !fs::is_directory(candidate, none)) return candidate;
  }
  const auto near = close_name(text, scenario_names());
  throw std::runtime_error(fmt::format(
      "{}: no such scenario; {}", text,
      near ? fmt::format("did you mean '{}'?", *near)
           : "give a file's path, or <world>/<name>; `castaway scenarios` lists the shipped ones"));
}

std::vector<std::string> world_names() { return folders_in(data_root() / "worlds"); }

std::vector<std::string> robot_names() { return folders_in(data_root() / "robots"); }

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  for (const std::string& world : world_names()) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(shipped_scenarios(world), none)) {
      if (entry.path().extension() != ".yaml") continue;
      names.push_back(world + "/" + entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_robot(const std::string& text, const fs::path& base) {
  const std::string name = fs::path(text).filename().string();
  return find("robot", text, base, {name + ".urdf", name + ".urdf.xacro", name + ".xacro"});
}

fs::path find_file(const std::string& text, const fs::path& base) {
  return fs::exists(text) ? fs::path(text) : base / text;
}

}  // namespace castaway::testbed
