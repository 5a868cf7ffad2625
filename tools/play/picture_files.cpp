#include "tools/play/picture_files.hpp"

#include "sim/robot/lidar_visuals.hpp"
#include "sim/robot/robot_visuals.hpp"
#include "sim/scene/bounds.hpp"
#include "sim/scene/primitives.hpp"
#include "sim/world/world_visuals.hpp"

namespace castaway::testbed {
namespace {

/// The floor, just below z = 0.
sim::SceneItem floor_item(const sim::WorldSpec& world) {
  sim::SceneItem item;
  item.mesh = sim::ground_mesh(world.min_corner.cast<float>(), world.max_corner.cast<float>());
  item.T_map_mesh.translation().z() = -0.003F;
  item.color = {0.80F, 0.77F, 0.72F};
  item.casts_shadow = false;
  item.instance = sim::kFloorInstance;
  return item;
}

std::size_t corners_of(const std::vector<sim::SceneItem>& items) {
  std::size_t corners = 0;
  for (const sim::SceneItem& item : items) corners += item.mesh.indices.size();
  return corners;
}

PictureWorld picture_world_of(const PreparedSimulation& prepared) {
  PictureWorld world;
  world.world = sim::world_visuals(prepared.config.world);
  std::vector<sim::SceneItem> open = sim::world_visuals_from_above(prepared.config.world);
  if (open.size() < world.world.size() || corners_of(open) < corners_of(world.world)) {
    world.from_above = std::move(open);
    world.from_above.push_back(floor_item(prepared.config.world));
  }
  world.world.push_back(floor_item(prepared.config.world));
  world.robot = sim::robot_visuals(prepared.config.robot);
  for (sim::SceneItem& item :
       sim::lidar_visuals(prepared.config.robot, prepared.config.lidars.front())) {
    world.robot.push_back(std::move(item));
  }
  world.top = sim::standing_height(world.world);
  world.min_corner = prepared.config.world.min_corner;
  world.max_corner = prepared.config.world.max_corner;
  world.robot_radius = prepared.config.robot.footprint_radius;
  world.map = prepared.map;
  return world;
}

std::map<int, std::string> instances_of(const sim::WorldSpec& world) {
  std::map<int, std::string> instances;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    instances[sim::kFirstObjectInstance + static_cast<int>(i)] = world.objects[i].name;
  }
  return instances;
}

}  // namespace

RunFiles picture_files(const OutputSpec& outputs, const std::filesystem::path& video,
                       const PreparedSimulation& prepared) {
  RunFiles files;
  files.report = outputs.report;
  files.player = outputs.player;
  files.picture_world.robot_radius = prepared.config.robot.footprint_radius;
  if (outputs.snapshots || outputs.camera || !video.empty()) {
    files.picture_world = picture_world_of(prepared);
  }
  files.camera = outputs.camera;
  if (outputs.camera) files.instances = instances_of(prepared.config.world);
  if (outputs.snapshots) files.pictures = outputs.pictures;
  if (video.empty()) return files;
  files.film = outputs.video;
  files.film->format.file = video;
  return files;
}

}  // namespace castaway::testbed
