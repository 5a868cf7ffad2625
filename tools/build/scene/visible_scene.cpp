#include "tools/build/scene/visible_scene.hpp"

#include <utility>

#include "sim/robot/robot_visuals.hpp"
#include "sim/scene/primitives.hpp"
#include "sim/scene/scene.hpp"
#include "sim/world/world_visuals.hpp"

namespace castaway::testbed {

sim::SceneItem floor_item(const sim::WorldSpec& world) {
  sim::SceneItem item;
  item.mesh = sim::ground_mesh(world.min_corner.cast<float>(), world.max_corner.cast<float>());
  item.T_map_mesh.translation().z() = -0.003F;
  item.color = {0.80F, 0.77F, 0.72F};
  item.casts_shadow = false;
  item.instance = sim::kFloorInstance;
  return item;
}

std::vector<sim::SceneItem> robot_items(const sim::RobotModel& robot,
                                        const std::vector<sim::LidarConfig>& lidars) {
  std::vector<sim::SceneItem> items = sim::robot_visuals(robot);
  for (sim::SceneItem& item : sim::lidar_visuals(robot, lidars.front())) {
    items.push_back(std::move(item));
  }
  return items;
}

PageWorld page_world(const sim::WorldSpec& world) {
  PageWorld page;
  page.floor_color = floor_item(world).color;
  page.min_corner = world.min_corner;
  page.max_corner = world.max_corner;
  for (sim::SceneItem& item : sim::world_visuals(world)) {
    (item.casts_shadow || world.levels ? page.items : page.roofs).push_back(std::move(item));
  }
  page.top = sim::standing_height(page.items);
  return page;
}

}  // namespace castaway::testbed
