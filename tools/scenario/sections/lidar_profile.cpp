#include "tools/scenario/sections/lidar_profile.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {

std::vector<std::string> lidar_profile_names() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(data_root() / "lidars", none)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

LidarProfile load_lidar_profile(const std::string& name) {
  const std::vector<std::string> names = lidar_profile_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    std::vector<std::string> known = {"robot", "ideal"};
    known.insert(known.end(), names.begin(), names.end());
    throw std::runtime_error(
        fmt::format("lidar profile '{}' not found; {}", name, suggestion(name, known)));
  }
  YamlDocument document = YamlDocument::load(data_root() / "lidars" / (name + ".yaml"));
  YamlReader root = document.root();
  LidarProfile profile;
  profile.name = name;
  profile.device = root.require<std::string>("device");
  profile.source = root.require<std::string>("source");
  profile.changes = read_lidar_changes(root);
  document.reject_unknown_keys();
  return profile;
}

sim::LidarConfig with_profile(const sim::LidarConfig& lidar, const std::string& profile) {
  if (profile == "robot") return lidar;
  sim::LidarConfig result = lidar;
  result.noise = {0.0, 0.0, 0.0, 0.0, 0.0};
  result.light = {};
  if (profile == "ideal") return result;
  result.elevations = {0.0};
  result.planar_layer.reset();
  return apply_changes(result, load_lidar_profile(profile).changes);
}

}  // namespace castaway::testbed
