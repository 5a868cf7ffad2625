#include "tools/play/observation/observed_scenario.hpp"

#include <algorithm>

#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/world/world_file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

bool is_sdf_file(const fs::path& file) {
  const std::string end = file.extension().string();
  return end == ".sdf" || end == ".world";
}

bool is_world(const std::string& text) {
  std::error_code none;
  if (is_sdf_file(text) || fs::is_regular_file(fs::path(text) / "world.yaml", none)) return true;
  return std::ranges::count(world_names(), text) > 0 && !fs::is_regular_file(text, none);
}

bool has_levels(const fs::path& world) {
  return !is_sdf_file(world) && load_world(world).spec.levels;
}

ObservedScenario in_world(const std::string& text, const std::vector<std::string>& overrides) {
  const fs::path file = find_world(text, ".");
  YamlDocument document =
      YamlDocument::parse(has_levels(file) ? "{robot: mule, lidar: {profile: vlp-16}}"
                                           : "{robot: waffle, lidar: {rate_hz: 10, range_max: 12}}",
                          text);
  document.set_text("world", text);
  for (const std::string& assignment : overrides) document.set(assignment);
  return {read_scenario(std::move(document), ".", fs::path(text).stem().string()), "."};
}

}  // namespace

ObservedScenario observed_scenario(const std::string& text,
                                   const std::vector<std::string>& overrides) {
  if (is_world(text)) return in_world(text, overrides);
  const fs::path file = find_scenario(text, ".");
  return {load_scenario(file, overrides), file.parent_path()};
}

}  // namespace castaway::testbed
