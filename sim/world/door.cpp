#include "sim/world/door.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {

WorldObject door_leaf(const Door& door, double open_deg) {
  const double angle = door.turn * open_deg * std::numbers::pi / 180.0;
  WorldObject leaf;
  leaf.name = door.name + "/leaf";
  leaf.shape = BoxShape{door.leaf};
  leaf.T_map_object = door.T_map_hinge * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) *
                      Eigen::Translation3d(0.5 * door.leaf.x(), 0.0, 0.5 * door.leaf.z());
  return leaf;
}

void set_door(WorldSpec& world, const std::string& name, double open_deg) {
  const auto named = [&](const auto& item) { return item.name == name; };
  const auto door = std::find_if(world.doors.begin(), world.doors.end(), named);
  const auto leaf =
      std::find_if(world.objects.begin(), world.objects.end(),
                   [&](const WorldObject& object) { return object.name == name + "/leaf"; });
  if (door == world.doors.end() || leaf == world.objects.end()) {
    throw std::invalid_argument(fmt::format("world {}: no door '{}'", world.name, name));
  }
  if (leaf->in_map) {  // The map still shows the leaf where it was surveyed.
    WorldObject surveyed = *leaf;
    surveyed.name = name + "/leaf on the map";
    surveyed.in_world = false;
    leaf->in_map = false;
    leaf->T_map_object = door_leaf(*door, open_deg).T_map_object;
    world.objects.push_back(std::move(surveyed));
  } else {
    leaf->T_map_object = door_leaf(*door, open_deg).T_map_object;
  }
  door->open_deg = open_deg;
}

}  // namespace castaway::sim
