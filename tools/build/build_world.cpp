#include "tools/build/build_world.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "localization/geometry/random.hpp"
#include "sim/map/building.hpp"
#include "sim/map/extrude.hpp"
#include "sim/map/free_choice.hpp"
#include "sim/map/grid_tools.hpp"
#include "sim/map/open_ground.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/world/floor.hpp"
#include "sim/world/sdf/load_sdf.hpp"
#include "tools/build/sim_conversion.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/files/foreign_world.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/yaml/nearest.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

constexpr double kMapResolution = 0.05;   // [m]
constexpr double kMostCells = 28e6;       // Of a survey; a run with people needs 70 bytes per cell.
constexpr double kNoRoom = 1.0;           // [m^2] Less free space counts as none.
constexpr double kReportedFloor = 0.001;  // [m] Greater floor heights are reported.
constexpr double kRobotHeight = 0.6;      // [m] What robots meet is not higher.
constexpr double kPlatform = 0.3;         // [m] At the start, higher objects are obstacles.

bool is_ros_map(const std::filesystem::path& path) {
  return YamlDocument::load(path).root().has("image");
}

/// Names that changes can refer to: bodies, pieces, doors and groups, but not their parts.
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
  world.difference = {.moved = changed.moved,
                      .removed = changed.removed,
                      .opened = changed.opened,
                      .closed = changed.closed,
                      .added = changed.added};
  for (const std::string& note : changed.notes) world.warnings.push_back("differences: " + note);
}

bool is_sdf(std::filesystem::path path) {
  if (path.extension() == ".xacro") path = path.stem();
  return path.extension() == ".sdf" || path.extension() == ".world";
}

/// Resolves search paths relative to the scenario's folder, or else to the current one.
std::vector<std::string> resolve_search_paths(const std::vector<std::string>& paths,
                                              const std::filesystem::path& base) {
  std::vector<std::string> result;
  for (const std::string& path : paths) {
    const bool from_base = std::filesystem::is_directory(base / path);
    result.push_back(from_base ? (base / path).string() : path);
  }
  return result;
}

/// Restricts the free space to the region of the run: the others become unknown.
void choose_space(const std::optional<Eigen::Vector2d>& start, double radius, LoadedWorld& world) {
  sim::FreeChoice choice = sim::choose_free(world.grid, radius, start);
  world.grid = std::move(choice.grid);
  if (const auto text = sim::describe(choice)) world.warnings.push_back(*text);
}

/// Cell size [m] at which the map of a world has at most `kMostCells` cells.
double survey_resolution(const sim::WorldSpec& spec) {
  const Eigen::Vector2d size = spec.max_corner - spec.min_corner;
  double resolution = kMapResolution;
  while (size.prod() > kMostCells * resolution * resolution) resolution *= 2.0;
  return resolution;
}

/// Cell size [m] of the map; adds a warning if the world is too large for the usual one.
double map_resolution(LoadedWorld& world) {
  const double resolution = survey_resolution(world.file.spec);
  if (resolution > kMapResolution) {
    world.warnings.push_back(fmt::format("a large world: its map has cells of {} m instead of {} m",
                                         resolution, kMapResolution));
  }
  return resolution;
}

/// Gives a world the extent of its free space, if that is much smaller.
void fit_extent(LoadedWorld& world) {
  const int before = world.grid.width * world.grid.height;
  world.grid = sim::crop_to_free(world.grid);
  const sim::Grid& grid = world.grid;
  if (grid.width * grid.height == before) return;
  world.file.spec.min_corner = grid.origin;
  world.file.spec.max_corner =
      grid.origin + grid.resolution * Eigen::Vector2d(grid.width, grid.height);
}

/// Cuts off what is so far away that a robot meets nothing of it.
void leave_out_specks(const SurveyOptions& options, LoadedWorld& world) {
  sim::WorldSpec& spec = world.file.spec;
  const auto box = sim::met_extent(spec, options.lidar_height, kRobotHeight);
  if (!box || (options.inside && !box->contains(*options.inside))) return;
  const Eigen::Vector2d before = spec.max_corner - spec.min_corner;
  spec.min_corner = box->min();
  spec.max_corner = box->max();
  world.warnings.push_back(fmt::format(
      "the extent is {:.0f} m x {:.0f} m instead of {:.0f} m x {:.0f} m: a robot meets nothing, or "
      "only specks, in the rest",
      box->sizes().x(), box->sizes().y(), before.x(), before.y()));
}

/// Keeps robots to a building whose doors lead outside, or to where models stand. On open ground
/// without either, they stay in sight of an object.
void keep_to_building(const SurveyOptions& options, const std::optional<sim::Ground>& ground,
                      LoadedWorld& world) {
  std::string where = "within 5 m of the objects";
  auto building = sim::enclosed_building(world.grid, options.robot_radius);
  if (!building && !ground) return;
  if (!building) {
    (void)sim::extend_over(*ground, world.file.spec);
    world.grid = sim::near_obstacles(
        sim::cut_world(world.file.spec, options.lidar_height, survey_resolution(world.file.spec)));
    building = sim::between_obstacles(world.grid, options.robot_radius);
  }
  if (building) {
    where = building->where;
    world.grid = std::move(building->grid);
  }
  world.warnings.push_back(fmt::format(
      "the ground goes on outside: robots keep {}; set `start` to begin elsewhere", where));
}

LoadedWorld sdf_world(const std::filesystem::path& path, const std::vector<std::string>& search,
                      const SurveyOptions& options) {
  LoadedWorld world;
  // Of no seed: a building is the same in every run.
  const auto streams = [](const std::string& name) { return localization::substream(0, name); };
  sim::SdfWorld loaded =
      sim::load_sdf(path.string(), {search, options.inside, options.strict, streams});
  world.file.spec = std::move(loaded.spec);
  world.file.spec.inside = options.inside;
  world.warnings = std::move(loaded.warnings);
  world.has_start = false;
  leave_out_specks(options, world);
  const auto cut = [&] {
    return sim::cut_world(world.file.spec, options.lidar_height,
                          survey_resolution(world.file.spec));
  };
  world.grid = cut();
  const sim::FreeChoice room = sim::choose_free(world.grid, options.robot_radius, options.inside);
  const bool open = room.at_edge || room.area < kNoRoom;
  if (open && !options.inside) {
    keep_to_building(options, loaded.ground, world);
  } else if (open && loaded.ground) {
    const auto line = sim::extend_over(*loaded.ground, world.file.spec);
    if (line) world.warnings.push_back(*line);
    world.grid = cut();
  }
  (void)map_resolution(world);
  choose_space(options.inside, options.robot_radius, world);
  world.grid = options.inside ? sim::component_at(world.grid, *options.inside)
                              : sim::largest_component(world.grid);
  if (!options.inside) fit_extent(world);
  return world;
}

LoadedWorld yaml_world(const std::filesystem::path& path, const SurveyOptions& options) {
  LoadedWorld world;
  world.file = load_world(path);
  sim::WorldSpec& spec = world.file.spec;
  const sim::Ground ground{0.0, {spec.min_corner, spec.max_corner}};
  const double floor = sim::floor_height(spec, ground, world.file.start.position());
  if (floor > kReportedFloor && floor <= kPlatform) {
    sim::settle(spec, floor);
    world.warnings.push_back(fmt::format(
        "the floor under the start is at z = {:.3f} m: heights are relative to it", floor));
  }
  world.grid = sim::rasterise(spec, options.lidar_height, map_resolution(world));
  return world;
}

LoadedWorld load_undisturbed(const WorldChoice& choice, const std::filesystem::path& base,
                             const SurveyOptions& options) {
  const std::filesystem::path path = find_world(choice.file, base);
  refuse_picture(path);
  refuse_foreign_world(path);
  if (!is_sdf(path) && is_ros_map(path)) return world_of_map(load_ros_map(path), options);
  LoadedWorld world =
      is_sdf(path) ? sdf_world(path, resolve_search_paths(choice.search_paths, base), options)
                   : yaml_world(path, options);
  world.map = to_ros_map(world.grid, world.file.spec.name);
  return world;
}

}  // namespace

LoadedWorld world_of_map(RosMap map, const SurveyOptions& options) {
  LoadedWorld world;
  world.map = std::move(map);
  world.warnings = world.map.warnings;
  world.grid = to_sim_grid(world.map);
  world.file.spec = sim::extrude(world.grid, options.wall_height, world.map.name);
  world.has_start = false;
  choose_space(options.inside, options.robot_radius, world);
  return world;
}

LoadedWorld build_world(const WorldChoice& choice, const std::filesystem::path& base,
                        const SurveyOptions& options) {
  LoadedWorld world = load_undisturbed(choice, base, options);
  if (!choice.map.empty()) world.map = load_ros_map(find_file(choice.map, base));
  world.file.spec.levels = choice.levels.value_or(world.file.spec.levels);
  apply(choice.differences.value_or(world.file.differences), options.seed, world);
  return world;
}

bool differs_from_map(const sim::WorldSpec& world) {
  return std::any_of(world.objects.begin(), world.objects.end(),
                     [](const auto& object) { return object.in_map != object.in_world; });
}

}  // namespace castaway::testbed
