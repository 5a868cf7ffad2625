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

/// True for a path rather than a shipped name, such as "lab" or "lab/kidnap".
bool is_path(const std::string& text) {
  const fs::path path(text);
  return path.is_absolute() || text.starts_with(".") || text.ends_with("/") || path.has_extension();
}

/// `path` leads to nothing, nor does it in `base`.
std::string missing_file_trouble(const fs::path& path, const fs::path& base) {
  const fs::path folder = path.parent_path();
  std::error_code none;
  const bool from_base = path.is_relative() && base != "." && !base.empty();
  const std::string also = from_base ? fmt::format(", nor in '{}'", base.string()) : "";
  if (!folder.empty() && !fs::is_directory(folder, none)) {
    return fmt::format("no such file: there is no folder '{}'{}", folder.string(), also);
  }
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, none)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const auto near = close_name(path.filename().string(), names);
  if (near) return fmt::format("no such file; did you mean '{}'?", (folder / *near).string());
  return fmt::format("no such file in {}{}",
                     folder.empty() ? "the current folder" : "'" + folder.string() + "'", also);
}

/// What is wrong with a path that leads to none of `files`; empty: nothing is there, and `text` is
/// no path. Without `files`, names may have a slash, as those of scenarios.
std::string path_trouble(const std::string& text, const fs::path& base,
                         const std::vector<std::string>& files) {
  fs::path path(text);
  std::error_code none;
  const auto is_there = [&](const fs::path& at) {
    return fs::exists(fs::symlink_status(at, none));
  };
  if (!is_there(path) && is_there(base / path)) path = base / path;
  const bool given = is_path(text) || (!files.empty() && text.find('/') != std::string::npos);
  if (text.empty() || (!given && !is_there(path))) return "";
  if (fs::is_directory(path, none)) {
    return fmt::format("is a folder without {}; give the file itself", fmt::join(files, ", "));
  }
  if (fs::exists(path, none)) return "is no regular file";
  if (fs::is_symlink(path, none)) return "is a link to a file that does not exist";
  return missing_file_trouble(path, base);
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
  const std::string trouble = path_trouble(text, base, files);
  if (!trouble.empty()) {
    throw std::runtime_error(fmt::format("{} '{}': {}", kind, text, trouble));
  }
  const std::vector<std::string> known = folders_in(shipped);
  const auto near = close_name(text, known);
  throw std::runtime_error(fmt::format(
      "{} '{}' not found: {}give a path, or one of: {}", kind, text,
      near ? fmt::format("did you mean '{}'? Or ", *near) : "", fmt::join(known, ", ")));
}

fs::path shipped_scenarios(const fs::path& world) {
  return data_root() / "worlds" / world / "scenarios";
}

}  // namespace

fs::path data_root() {
  const char* named = std::getenv("CASTAWAY_DATA");
  fs::path root = named != nullptr ? fs::path(named) : shipped_data();
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
  const std::string trouble = path_trouble(text, base, {});
  if (!trouble.empty()) throw std::runtime_error(fmt::format("{}: {}", text, trouble));
  const auto near = close_name(text, scenario_names());
  throw std::runtime_error(fmt::format(
      "{}: no such scenario; {}", text,
      near ? fmt::format("did you mean '{}'?", *near)
           : "give a file's path, or <world>/<name>; `castaway scenarios` lists the shipped ones"));
}

std::string find_shipped(const std::string& text) {
  std::error_code none;
  if (text.empty() || fs::exists(text, none) || fs::path(text).is_absolute()) return text;
  const fs::path shipped = data_root() / text;
  return fs::exists(shipped, none) ? shipped.string() : text;
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
