#include "tools/scenario/sections/world_events.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/scenario/sections/people_yaml.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {
namespace {

constexpr double kLongestEdge = 1000.0;  // [m] As in world files.
constexpr double kThinnest = 1e-3;       // [m]
const Eigen::Vector3f kPutColor(0.85F, 0.55F, 0.25F);

/// Frame on the floor at `at`, with z of `middle`.
Eigen::Isometry3d standing_frame(Settings& settings, double middle) {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double yaw_deg = 0.0;
  settings.field({"at", "m", "Position x, y in map.", {-kFarthest, kFarthest}}, at);
  settings.field({"yaw_deg", "deg", "Heading.", {-360.0, 360.0}}, yaw_deg);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << at, middle;
  T.rotate(Eigen::AngleAxisd(yaw_deg * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ()));
  return T;
}

void common_fields(Settings& settings, const std::string& given_name, sim::WorldObject& object) {
  object.name = given_name;
  object.color = kPutColor;
  object.in_map = false;
  settings.field({"name", "", "Its name, unique in the world."}, object.name);
  settings.field({"reflectivity", "", "Share of the light that it reflects.", {0.0, 1.0}},
                 object.surface.reflectivity);
}

sim::PutObject box_fields(Settings& settings, const std::string& given_name) {
  sim::PutObject put;
  Eigen::Vector3d size(0.5, 0.5, 0.5);
  settings.field({"size", "m", "Edges along x, y and z.", {kThinnest, kLongestEdge}}, size);
  put.object.shape = sim::BoxShape{size};
  put.object.T_map_object = standing_frame(settings, 0.5 * size.z());
  common_fields(settings, given_name, put.object);
  return put;
}

sim::PutObject cylinder_fields(Settings& settings, const std::string& given_name) {
  sim::PutObject put;
  sim::CylinderShape shape{0.25, 1.0};
  settings.field({"radius", "m", "Radius.", {kThinnest, kLongestEdge}}, shape.radius);
  settings.field({"height", "m", "Height.", {kThinnest, kLongestEdge}}, shape.height);
  put.object.shape = shape;
  put.object.T_map_object = standing_frame(settings, 0.5 * shape.height);
  common_fields(settings, given_name, put.object);
  return put;
}

sim::TakeObject remove_fields(Settings& settings) {
  sim::TakeObject take;
  settings.field({"name", "", "Name of a box or cylinder that was put there."}, take.name);
  return take;
}

sim::TurnDoor door_fields(Settings& settings) {
  sim::TurnDoor door;
  settings.field({"name", "", "Name of the door in its world file."}, door.name);
  settings.field({"open_deg", "deg", "Opening angle; 0: closed.", {-180.0, 180.0}}, door.open_deg);
  return door;
}

sim::AddPeople people_fields(Settings& settings) {
  sim::AddPeople people;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  settings.field({"at",
                  "m",
                  "Position x, y of the first, or of the middle of a group that talks.",
                  {-kFarthest, kFarthest}},
                 at);
  double yaw_deg = 0.0;
  settings.field({"yaw_deg", "deg", "Heading of the first.", {-360.0, 360.0}}, yaw_deg);
  people.T_map_person = {at.x(), at.y(), yaw_deg * std::numbers::pi / 180.0};
  settings.field({"count", "", "1: alone; more: a group that walks together or talks.", {1.0, 6.0}},
                 people.count);
  settings.field({"walk", "", "They walk from place to place (a group: at most 4)."}, people.walk);
  settings.choice({"behaviour", "", "Their reaction to the robot."}, people.behaviour,
                  behaviours());
  return people;
}

}  // namespace

void fields(Settings settings, const std::string& name, const std::string& given_name,
            sim::WorldChange& change) {
  settings.field({"at_s", "s", "Simulated time; it waits until there is room.", {0.0, kLongest}},
                 change.at_s);
  if (name == "box") change.what = box_fields(settings, given_name);
  if (name == "cylinder") change.what = cylinder_fields(settings, given_name);
  if (name == "remove") change.what = remove_fields(settings);
  if (name == "door") change.what = door_fields(settings);
  if (name == "people") change.what = people_fields(settings);
}

sim::WorldChange read_world_change(const std::string& name, YamlReader body,
                                   const std::string& given_name) {
  (void)body.require<double>("at_s");
  if (name == "remove" || name == "door") (void)body.require<std::string>("name");
  if (name == "door") (void)body.require<double>("open_deg");
  if (name != "remove" && name != "door") (void)body.require<Eigen::Vector2d>("at");
  sim::WorldChange change;
  fields(Settings::reading(body), name, given_name, change);
  return change;
}

}  // namespace castaway::testbed
