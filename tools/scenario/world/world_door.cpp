// Doors of world files: two posts and a leaf.
#include <numbers>

#include <fmt/format.h>

#include "sim/world/door.hpp"
#include "tools/scenario/world/object_reader.hpp"

namespace castaway::testbed {
namespace {

constexpr double kDoorGap = 0.005;  // [m] Between the leaf and the posts.

/// `at` is the centre of the opening, x along the closed leaf; the leaf opens towards +y.
sim::Door door_of(YamlReader& reader, const Eigen::Isometry3d& T_map_door, double width) {
  sim::Door door;
  const bool right = reader.choice("hinge", "left", {"left", "right"}) == "right";
  door.leaf = {width - 2.0 * kDoorGap, positive(reader, "leaf", 0.04),
               positive(reader, "height", 2.0)};
  if (door.leaf.x() <= 0.0) reader.find("width")->fail("a door is wider than 0.01 m");
  door.open_deg = reader.get("open_deg", 0.0);
  if (door.open_deg < -180.0 || door.open_deg > 180.0) {
    reader.find("open_deg")->fail("must be from -180 to 180 (0: closed)");
  }
  door.turn = right ? -1.0 : 1.0;
  door.T_map_hinge =
      translate(T_map_door, {(right ? 0.5 : -0.5) * (width - 2.0 * kDoorGap), 0.0, 0.0});
  if (right) door.T_map_hinge.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
  return door;
}

/// Adds the actual leaf and, if it differs, the leaf as shown on the map.
void add_leaf(YamlReader& reader, const sim::Door& door, Bodies& out) {
  constexpr double kOpenOnMap = 90.0;  // [deg]
  const std::string shown = reader.choice("in_map", "as_is", {"as_is", "open", "closed", "none"});
  sim::WorldObject leaf = sim::door_leaf(door, door.open_deg);
  leaf.name = "leaf";
  leaf.in_map = shown == "as_is";
  out.bodies.push_back(leaf);
  if (shown == "as_is" || shown == "none") return;
  leaf = sim::door_leaf(door, shown == "open" ? kOpenOnMap : 0.0);
  leaf.name = "leaf on the map";
  leaf.in_map = true;
  leaf.in_world = false;
  out.bodies.push_back(leaf);
}

}  // namespace

Bodies read_door(YamlReader& reader) {
  const double width = required_positive(reader, "width");
  const double post = positive(reader, "frame", 0.05);
  const double thickness = positive(reader, "thickness", 0.1);
  const Eigen::Isometry3d T_map_door = floor_frame(reader);
  const sim::Door door = door_of(reader, T_map_door, width);
  Bodies result;
  for (const double side : {-1.0, 1.0}) {
    result.bodies.push_back(box_at(T_map_door, {side * 0.5 * (width + post), 0.0, 0.0},
                                   {post, thickness, door.leaf.z()}));
    result.bodies.back().name = side < 0.0 ? "post-left" : "post-right";
  }
  add_leaf(reader, door, result);
  result.doors.push_back(door);
  result.named = true;
  return result;
}

}  // namespace castaway::testbed
