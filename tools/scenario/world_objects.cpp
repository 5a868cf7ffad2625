#include "tools/scenario/world_objects.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

using sim::BoxShape;
using sim::CylinderShape;
using sim::MeshShape;
using sim::WorldObject;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTableTop = 0.03;  // [m] Thickness.

double positive(YamlReader& reader, const std::string& key, double fallback) {
  const double value = reader.get(key, fallback);
  if (value <= 0.0) reader.find(key)->fail("must be above 0 (metres)");
  return value;
}

double required_positive(YamlReader& reader, const std::string& key) {
  (void)reader.require<double>(key);
  return positive(reader, key, 1.0);
}

Eigen::Vector3d size_of(YamlReader& reader) {
  const auto size = reader.require<Eigen::Vector3d>("size");
  if (size.minCoeff() <= 0.0) reader.find("size")->fail("each edge must be above 0 (metres)");
  return size;
}

/// "#rrggbb"
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

/// The frame of an object on the floor: x and y from `at`, turned by `yaw_deg`, z at its underside.
Eigen::Isometry3d floor_frame(YamlReader& reader) {
  const auto at = reader.require<Eigen::Vector2d>("at");
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << at, reader.get("bottom", 0.0);
  T.rotate(Eigen::AngleAxisd(reader.get("yaw_deg", 0.0) * kDegree, Eigen::Vector3d::UnitZ()));
  return T;
}

Eigen::Isometry3d shifted(const Eigen::Isometry3d& T, const Eigen::Vector3d& by) {
  return T * Eigen::Translation3d(by);
}

/// Bodies without their names.
using Bodies = std::vector<WorldObject>;

WorldObject body(sim::ObjectShape shape, const Eigen::Isometry3d& T_map_object) {
  return {"", std::move(shape), T_map_object};
}

Bodies read_box(YamlReader& reader) {
  const Eigen::Vector3d size = size_of(reader);
  return {body(BoxShape{size}, shifted(floor_frame(reader), {0.0, 0.0, 0.5 * size.z()}))};
}

Bodies read_cylinder(YamlReader& reader) {
  const CylinderShape shape{required_positive(reader, "radius"),
                            required_positive(reader, "height")};
  return {body(shape, shifted(floor_frame(reader), {0.0, 0.0, 0.5 * shape.height}))};
}

Bodies read_table(YamlReader& reader) {
  const Eigen::Vector3d size = size_of(reader);
  const double leg = positive(reader, "leg", 0.05);
  const double height = size.z() - kTableTop;
  if (height <= 0.0) reader.find("size")->fail("a table is higher than its top of 0.03 m");
  const Eigen::Isometry3d T_map_table = floor_frame(reader);
  Bodies bodies{body(BoxShape{{size.x(), size.y(), kTableTop}},
                     shifted(T_map_table, {0.0, 0.0, size.z() - 0.5 * kTableTop}))};
  for (const double side_x : {-0.5, 0.5}) {
    for (const double side_y : {-0.5, 0.5}) {
      bodies.push_back(body(BoxShape{{leg, leg, height}},
                            shifted(T_map_table, {side_x * (size.x() - leg),
                                                  side_y * (size.y() - leg), 0.5 * height})));
    }
  }
  return bodies;
}

Bodies read_mesh(YamlReader& reader, const std::filesystem::path& folder) {
  const auto path = folder / reader.require<std::string>("file");
  if (!std::filesystem::exists(path)) {
    reader.find("file")->fail(fmt::format("there is no file {}", path.string()));
  }
  const double scale = positive(reader, "scale", 1.0);
  const MeshShape shape{std::filesystem::absolute(path).lexically_normal().string(),
                        Eigen::Vector3d::Constant(scale)};
  return {body(shape, floor_frame(reader))};
}

/// How a wall's segments stand.
struct WallProfile {
  double thickness;
  double height;
  double bottom;
};

/// A box along the segment, longer by half the thickness at each end that is a corner.
WorldObject wall_segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool corner_from,
                         bool corner_to, const WallProfile& wall) {
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d begin = from - along * (corner_from ? 0.5 * wall.thickness : 0.0);
  const Eigen::Vector2d end = to + along * (corner_to ? 0.5 * wall.thickness : 0.0);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << 0.5 * (begin + end), wall.bottom + 0.5 * wall.height;
  T.rotate(Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Eigen::Vector3d::UnitZ()));
  return body(BoxShape{{(end - begin).norm(), wall.thickness, wall.height}}, T);
}

Bodies read_wall(YamlReader& reader) {
  std::vector<Eigen::Vector2d> points;
  for (const YamlReader& point : reader.list("points")) {
    points.push_back(point.as<Eigen::Vector2d>());
    const std::size_t n = points.size();
    if (n > 1 && points[n - 1] == points[n - 2]) point.fail("the same point twice");
  }
  const bool closed = reader.get("closed", false);
  const WallProfile wall{positive(reader, "thickness", 0.1), positive(reader, "height", 2.4),
                         reader.get("bottom", 0.0)};
  if (points.size() < (closed ? 3U : 2U)) reader.fail("a wall needs `points`: 2, or 3 if closed");
  Bodies bodies;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const bool is_last = i + 2 == points.size();
    bodies.push_back(
        wall_segment(points[i], points[i + 1], closed || i > 0, closed || !is_last, wall));
  }
  if (closed) bodies.push_back(wall_segment(points.back(), points.front(), true, true, wall));
  return bodies;
}

Bodies read_bodies(const std::string& kind, YamlReader& reader,
                   const std::filesystem::path& folder) {
  if (kind == "box") return read_box(reader);
  if (kind == "cylinder") return read_cylinder(reader);
  if (kind == "table") return read_table(reader);
  if (kind == "mesh") return read_mesh(reader, folder);
  if (kind == "wall") return read_wall(reader);
  reader.fail("no such kind of object; known are box, cylinder, table, mesh, wall");
}

}  // namespace

std::vector<WorldObject> read_world_object(YamlReader& entry, std::size_t index,
                                           const std::filesystem::path& folder) {
  auto [kind, reader] = entry.named();
  Bodies bodies = read_bodies(kind, reader, folder);
  const std::string name = reader.get("name", fmt::format("{}-{}", kind, index));
  const Eigen::Vector3f color = color_of(reader, kind == "wall" ? "#e8e6e1" : "#b3b3b3");
  const bool in_map = reader.get("in_map", true);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].name = bodies.size() == 1 ? name : fmt::format("{}/{}", name, i);
    bodies[i].color = color;
    bodies[i].in_map = in_map;
  }
  return bodies;
}

}  // namespace castaway::testbed
