#include "tools/run/build_world.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "localization/random.hpp"
#include "sim/world/extrude.hpp"
#include "sim/world/rasterise.hpp"
#include "sim/world/sdf/load_sdf.hpp"
#include "tools/run/simulator_source.hpp"
#include "tools/scenario/data_paths.hpp"
#include "tools/scenario/nearest.hpp"
#include "tools/scenario/ros_map_file.hpp"
#include "tools/scenario/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

constexpr double kMapResolution = 0.05;  // [m]

bool is_ros_map(const std::filesystem::path& path) {
  return YamlDocument::load(path).root().has("image");
}

/// Names that changes can go by: bodies, pieces, doors, groups, without their parts.
std::vector<std::string> names_in(const sim::WorldSpec& world, bool doors) {
  std::set<std::string> names;
  if (doors) {
    for (const sim::Door& door : world.doors) names.insert(door.name);
  } else {
    for (const sim::WorldObject& object : world.objects) {
      for (std::size_t slash = object.name.find('/'); slash != std::string::npos;
           slash = object.name.find('/', slash + 1)) {
        names.insert(object.name.substr(0, slash));
      }
      names.insert(object.name);
    }
  }
  return {names.begin(), names.end()};
}

void check_names(const sim::DifferenceSpec& spec, const sim::WorldSpec& world) {
  using Kind = sim::Change::Kind;
  for (const sim::Change& change : spec.changes) {
    if (change.kind == Kind::kAdd) continue;
    const bool door = change.kind == Kind::kOpen || change.kind == Kind::kClose;
    const std::vector<std::string> names = names_in(world, door);
    if (std::find(names.begin(), names.end(), change.name) != names.end()) continue;
    throw std::runtime_error(fmt::format("differences: world {} has no {} '{}'; {}", world.name,
                                         door ? "door" : "object", change.name,
                                         suggestion(change.name, names)));
  }
}

void apply(const sim::DifferenceSpec& spec, std::uint64_t seed, LoadedWorld& world) {
  if (spec.empty()) return;
  check_names(spec, world.file.spec);
  sim::KeepClear keep;
  for (const auto& [name, route] : world.file.routes) keep.routes.push_back(route);
  if (world.has_start) keep.start = world.file.start.position();
  sim::Rng rng = localization::substream(spec.seed.value_or(seed), "differences");
  sim::ChangedWorld changed =
      sim::change_world(std::move(world.file.spec), spec, world.grid, keep, rng);
  world.file.spec = std::move(changed.world);
  world.difference = {changed.moved, changed.removed, changed.opened, changed.closed,
                      changed.added};
  for (const std::string& note : changed.notes) world.warnings.push_back("differences: " + note);
}

bool is_sdf(const std::filesystem::path& path) {
  return path.extension() == ".sdf" || path.extension() == ".world";
}

/// Search paths from the scenario's folder, or from the current one where they are not there.
std::vector<std::string> found_from(const std::vector<std::string>& paths,
                                    const std::filesystem::path& base) {
  std::vector<std::string> result;
  for (const std::string& path : paths) {
    const bool from_base = std::filesystem::is_directory(base / path);
    result.push_back(from_base ? (base / path).string() : path);
  }
  return result;
}

LoadedWorld sdf_world(const std::filesystem::path& path, const std::vector<std::string>& search) {
  LoadedWorld world;
  sim::SdfWorld loaded = sim::load_sdf(path.string(), search);
  world.file.spec = std::move(loaded.spec);
  world.warnings = std::move(loaded.warnings);
  world.has_start = false;
  return world;
}

LoadedWorld load_undisturbed(const WorldChoice& choice, const std::filesystem::path& base,
                             const SurveyOptions& options) {
  const std::filesystem::path path = find_world(choice.file, base);
  if (!is_sdf(path) && is_ros_map(path))
    return world_of_map(load_ros_map(path), options.wall_height);
  LoadedWorld world;
  if (is_sdf(path)) {
    world = sdf_world(path, found_from(choice.search_paths, base));
    if (options.inside) world.file.spec.inside = options.inside;
  } else {
    world.file = load_world(path);
  }
  world.grid = sim::rasterise(world.file.spec, options.lidar_height, kMapResolution);
  world.map = to_ros_map(world.grid, world.file.spec.name);
  return world;
}

}  // namespace

LoadedWorld world_of_map(RosMap map, double wall_height) {
  LoadedWorld world;
  world.map = std::move(map);
  world.grid = to_sim_grid(world.map);
  world.file.spec = sim::extrude(world.grid, wall_height, world.map.name);
  world.has_start = false;
  return world;
}

LoadedWorld build_world(const WorldChoice& choice, const std::filesystem::path& base,
                        const SurveyOptions& options) {
  LoadedWorld world = load_undisturbed(choice, base, options);
  apply(choice.differences.value_or(world.file.differences), options.seed, world);
  return world;
}

bool differs_from_map(const sim::WorldSpec& world) {
  return std::any_of(world.objects.begin(), world.objects.end(),
                     [](const auto& object) { return object.in_map != object.in_world; });
}

}  // namespace castaway::testbed
