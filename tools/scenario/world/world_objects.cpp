#include "tools/scenario/world/world_objects.hpp"

#include <charconv>
#include <iterator>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

Bodies read_repeat(YamlReader& reader, const std::filesystem::path& folder);

/// Whether a kind is furniture by default.
bool is_furniture(const std::string& kind) {
  return kind == "box" || kind == "cylinder" || kind == "sphere" || kind == "table" ||
         kind == "chair" || kind == "shelf" || kind == "mesh";
}

const char* standard_color(const std::string& kind) {
  if (kind == "wall" || kind == "window") return "#e8e6e1";
  if (kind == "glass") return "#bfe3ee";
  if (kind == "door") return "#b98a5a";
  return "#b3b3b3";
}

/// Parses "#rrggbb".
Eigen::Vector3f color_of(YamlReader& reader, const char* fallback) {
  const std::string text = reader.get("color", fallback);
  unsigned rgb = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), rgb, 16);
  if (text.size() != 7 || text[0] != '#' || error != std::errc{} ||
      end != text.data() + text.size()) {
    reader.find("color")->fail(fmt::format("'{}' is no colour; write \"#rrggbb\"", text));
  }
  return Eigen::Vector3f(static_cast<float>(rgb >> 16U & 255U),
                         static_cast<float>(rgb >> 8U & 255U), static_cast<float>(rgb & 255U)) /
         255.0F;
}

Bodies read_bodies(const std::string& kind, YamlReader& reader,
                   const std::filesystem::path& folder) {
  if (kind == "box") return read_box(reader);
  if (kind == "step") return read_step(reader);
  if (kind == "ramp") return read_ramp(reader);
  if (kind == "cylinder") return read_cylinder(reader);
  if (kind == "sphere") return read_sphere(reader);
  if (kind == "table") return read_table(reader);
  if (kind == "chair") return read_chair(reader);
  if (kind == "shelf") return read_shelf(reader);
  if (kind == "mesh") return read_mesh(reader, folder);
  if (kind == "wall") return read_wall(reader);
  if (kind == "glass") return read_glass(reader);
  if (kind == "window") return read_window(reader);
  if (kind == "door") return read_door(reader);
  if (kind == "repeat") return read_repeat(reader, folder);
  reader.fail(
      "no such kind of object; known are box, chair, cylinder, door, glass, mesh, ramp, repeat, "
      "shelf, sphere, step, table, wall, window");
}

/// Reads whether the object is in the world, on the map, or both.
void read_presence(YamlReader& reader, const std::string& kind, Bodies& bodies) {
  const bool in_world = reader.get("in_world", true);
  if (kind == "door") {
    if (!in_world) reader.find("in_world")->fail("a door is in the world; see `in_map`");
    return;  // Doors have an `in_map` of their own.
  }
  const bool in_map = reader.get("in_map", true);
  if (!in_world && !in_map) reader.fail("neither in the world nor on the map: leave it out");
  for (sim::WorldObject& object : bodies.bodies) {
    object.in_world = in_world;
    object.in_map = in_map;
  }
}

double read_reflectivity(YamlReader& reader, double fallback) {
  const double value = reader.get("reflectivity", fallback);
  if (value < 0.0 || value > 1.0) reader.find("reflectivity")->fail("must be from 0 to 1");
  return value;
}

/// Reads the keys that all kinds have.
void read_common(YamlReader& reader, const std::string& kind, Bodies& bodies) {
  const Eigen::Vector3f color = color_of(reader, standard_color(kind));
  const double reflectivity = read_reflectivity(reader, sim::Surface{}.reflectivity);
  const bool movable = reader.get("movable", is_furniture(kind));
  const auto glass = reader.get_optional<bool>("glass");
  const auto drivable = reader.get_optional<bool>("drivable");
  for (sim::WorldObject& object : bodies.bodies) {
    const bool leaf = object.name.starts_with("leaf");
    object.color = object.surface.glass ? Eigen::Vector3f(0.75F, 0.89F, 0.93F) : color;
    object.surface.reflectivity = reflectivity;
    object.movable = movable;
    if (glass && (kind != "door" || leaf)) object.surface.glass = *glass;
    if (drivable) object.drivable = *drivable;
  }
  read_presence(reader, kind, bodies);
}

void give_names(const std::string& name, bool furniture, Bodies& bodies) {
  const std::size_t count = bodies.bodies.size();
  for (std::size_t i = 0; i < count; ++i) {
    sim::WorldObject& object = bodies.bodies[i];
    const std::string part = bodies.named ? object.name : fmt::format("{}", i);
    object.name = count == 1 ? name : fmt::format("{}/{}", name, part);
    if (furniture) object.piece = name;
  }
  for (sim::Door& door : bodies.doors) door.name = name;
}

/// Adds one copy of a group, moved and with a name prefix.
void append_copy(const Bodies& group, const Eigen::Isometry3d& T, const std::string& prefix,
                 Bodies& out) {
  for (sim::WorldObject object : group.bodies) {
    object.T_map_object = T * object.T_map_object;
    object.name = prefix + object.name;
    if (!object.piece.empty()) object.piece = prefix + object.piece;
    out.bodies.push_back(std::move(object));
  }
  for (sim::Door door : group.doors) {
    door.T_map_hinge = T * door.T_map_hinge;
    door.name = prefix + door.name;
    out.doors.push_back(std::move(door));
  }
}

Bodies read_group(YamlReader& reader, const std::filesystem::path& folder) {
  Bodies group;
  std::size_t index = 0;
  for (YamlReader entry : reader.list("objects")) {
    Bodies read = read_world_object(entry, index++, folder);
    std::move(read.bodies.begin(), read.bodies.end(), std::back_inserter(group.bodies));
    std::move(read.doors.begin(), read.doors.end(), std::back_inserter(group.doors));
  }
  if (group.bodies.empty()) reader.fail("nothing to repeat; give `objects`");
  return group;
}

Bodies read_repeat(YamlReader& reader, const std::filesystem::path& folder) {
  const auto count = reader.require<Eigen::Vector2d>("count");
  const auto spacing = reader.get<Eigen::Vector2d>("spacing", Eigen::Vector2d::Zero());
  if (count != count.array().round().matrix() || count.minCoeff() < 1.0 || count.prod() > 1e4) {
    reader.find("count")->fail("give two whole numbers [along x, along y], each from 1");
  }
  const Eigen::Isometry3d T_map_group = floor_frame(reader);
  const Bodies group = read_group(reader, folder);
  if (static_cast<double>(group.bodies.size()) * count.prod() > kMaxBodies) {
    reader.fail(fmt::format("more than {} bodies; repeat fewer", kMaxBodies));
  }
  Bodies result;
  result.named = true;
  for (int row = 0; row < static_cast<int>(count.y()); ++row) {
    for (int column = 0; column < static_cast<int>(count.x()); ++column) {
      const Eigen::Vector3d place(column * spacing.x(), row * spacing.y(), 0.0);
      append_copy(group, translate(T_map_group, place), fmt::format("{}-{}/", column, row), result);
    }
  }
  return result;
}

}  // namespace

Bodies read_world_object(YamlReader& entry, std::size_t index,
                         const std::filesystem::path& folder) {
  auto [kind, reader] = entry.name_and_body();
  Bodies bodies = read_bodies(kind, reader, folder);
  const std::string name = reader.get("name", fmt::format("{}-{}", kind, index));
  if (kind == "repeat") {
    Bodies renamed;
    append_copy(bodies, Eigen::Isometry3d::Identity(), name + "/", renamed);
    return renamed;
  }
  read_common(reader, kind, bodies);
  give_names(name, is_furniture(kind), bodies);
  return bodies;
}

}  // namespace castaway::testbed
