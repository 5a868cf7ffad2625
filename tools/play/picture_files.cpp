#include "tools/play/picture_files.hpp"

#include "sim/scene/bounds.hpp"
#include "sim/world/world_visuals.hpp"
#include "tools/scene/visible_scene.hpp"

namespace castaway::testbed {
namespace {

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
  world.robot = robot_items(prepared.config.robot, prepared.config.lidars);
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
  if (files.report && files.player) {
    files.scene = PageScene{page_world(prepared.config.world),
                            robot_items(prepared.config.robot, prepared.config.lidars)};
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
