#include "tools/play/picture_files.hpp"

#include <algorithm>
#include <utility>

#include "sim/events/world_change.hpp"
#include "sim/map/level_plane.hpp"
#include "sim/scene/scene.hpp"
#include "sim/world/world_visuals.hpp"
#include "tools/build/map3d/level_maps.hpp"
#include "tools/build/scene/visible_scene.hpp"

namespace castaway::testbed {
namespace {

std::size_t corners_of(const std::vector<sim::SceneItem>& items) {
  std::size_t corners = 0;
  for (const sim::SceneItem& item : items) corners += item.mesh.indices.size();
  return corners;
}

/// A world with only those objects that are among `names`, or only the others.
sim::WorldSpec part_of(sim::WorldSpec world, const std::set<std::string>& names, bool among) {
  for (sim::WorldObject& object : world.objects) {
    object.in_world = object.in_world && names.contains(object.name) == among;
  }
  return world;
}

/// Objects that events change, with what they look like at first and after each change.
std::map<std::string, PageStates> changing_states(const sim::SimulationConfig& config) {
  std::vector<sim::WorldChange> changes = config.events.changes;
  std::ranges::stable_sort(changes, {}, &sim::WorldChange::at_s);
  std::erase_if(changes, [](const sim::WorldChange& change) {
    return std::holds_alternative<sim::AddPeople>(change.what);
  });
  sim::WorldSpec world = config.world;
  const auto look = [&](const std::string& name) {
    return sim::world_visuals(part_of(world, {name, name + "/leaf"}, true));
  };
  std::map<std::string, PageStates> states;
  for (const sim::WorldChange& change : changes) {
    const std::string name = sim::name_of(change);
    if (!states.contains(name)) states[name].push_back(look(name));
    sim::apply(change, world);
    states[name].push_back(look(name));
  }
  return states;
}

PageScene page_scene_of(const sim::SimulationConfig& config) {
  const std::set<std::string> changing = changing_objects(config.events.changes);
  PageScene scene{page_world(part_of(config.world, changing, false)),
                  robot_items(config.robot, config.lidars)};
  scene.changing = changing_states(config);
  return scene;
}

std::function<std::optional<double>(const Eigen::Vector2d&)> lowest_ground_of(
    std::shared_ptr<const sim::LevelPlane> levels) {
  return [levels = std::move(levels)](const Eigen::Vector2d& p_map) -> std::optional<double> {
    const auto T_plane_point = levels->on_level({p_map.x(), p_map.y(), 0.0}, std::nullopt);
    if (!T_plane_point) return std::nullopt;
    return levels->p_map({T_plane_point->x, T_plane_point->y}).z();
  };
}

PictureWorld picture_world_of(const PreparedSimulation& prepared) {
  PictureWorld world;
  const sim::WorldSpec fixed =
      part_of(prepared.config.world, changing_objects(prepared.config.events.changes), false);
  world.world = sim::world_visuals(fixed);
  std::vector<sim::SceneItem> open = sim::world_visuals_from_above(fixed);
  if (open.size() < world.world.size() || corners_of(open) < corners_of(world.world)) {
    world.from_above = std::move(open);
    world.from_above.push_back(floor_item(prepared.config.world));
  }
  world.world.push_back(floor_item(prepared.config.world));
  world.robot = robot_items(prepared.config.robot, prepared.config.lidars);
  world.top = sim::standing_height(world.world);
  world.min_corner = prepared.config.world.min_corner;
  world.max_corner = prepared.config.world.max_corner;
  world.robot_radius = prepared.config.robot.footprint_radius;
  world.map = known_part(prepared.map);
  if (prepared.config.levels) world.lowest_ground = lowest_ground_of(prepared.config.levels);
  return world;
}

std::map<int, std::string> instances_of(const sim::SimulationConfig& config) {
  const sim::WorldSpec world = sim::world_after(config.world, config.events.changes);
  std::map<int, std::string> instances;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    instances[sim::kFirstObjectInstance + static_cast<int>(i)] = world.objects[i].name;
  }
  return instances;
}

}  // namespace

std::set<std::string> changing_objects(const std::vector<sim::WorldChange>& changes) {
  std::set<std::string> names;
  for (const sim::WorldChange& change : changes) {
    names.insert(sim::name_of(change));
    names.insert(sim::name_of(change) + "/leaf");
  }
  return names;
}

std::function<std::vector<sim::SceneItem>()> moving_items(const SimulatorSource& source,
                                                          bool people,
                                                          std::set<std::string> changing) {
  if (!people && changing.empty()) return {};
  return [&source, changing = std::move(changing)] {
    std::vector<sim::SceneItem> items = source.people_items();
    if (changing.empty()) return items;
    for (sim::SceneItem& item : sim::world_visuals(part_of(source.world(), changing, true))) {
      items.push_back(std::move(item));
    }
    return items;
  };
}

RunFiles picture_files(const OutputSpec& outputs, const std::filesystem::path& video,
                       const ReportWriter& report, const PreparedSimulation& prepared) {
  RunFiles files;
  if (outputs.report) files.report = report;
  if (files.report && prepared.config.levels) {
    files.levels = std::make_shared<const LevelMaps>(level_maps(*prepared.config.levels));
  }
  files.player = outputs.player;
  files.picture_world.robot_radius = prepared.config.robot.footprint_radius;
  if (outputs.snapshots || outputs.camera || !video.empty()) {
    files.picture_world = picture_world_of(prepared);
  }
  if (files.report && files.player) {
    files.scene = page_scene_of(prepared.config);
  }
  files.camera = outputs.camera;
  if (outputs.camera) files.instances = instances_of(prepared.config);
  if (outputs.snapshots) files.pictures = outputs.pictures;
  if (video.empty()) return files;
  files.film = outputs.video;
  files.film->format.file = video;
  return files;
}

}  // namespace castaway::testbed
