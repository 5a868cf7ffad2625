#include "tools/scenario/world/world_file.hpp"

#include <iterator>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "sim/world/world.hpp"
#include "tools/scenario/sections/name_yaml.hpp"
#include "tools/scenario/world/difference_yaml.hpp"
#include "tools/scenario/world/world_objects.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

/// Twice the signed area of a triangle.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
  return turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0;
}

/// True if two edges without a common corner intersect.
bool crosses_itself(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;  // These edges share the first corner.
      if (cross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) return true;
    }
  }
  return false;
}

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += turn(polygon[0], polygon[i - 1], polygon[i]);
  }
  return std::abs(0.5 * twice);
}

Polygon read_outline(YamlReader& zone) {
  constexpr std::size_t kMaxCorners = 1000;
  Polygon polygon;
  for (const YamlReader& point : zone.list("outline")) {
    polygon.push_back(point.as<Eigen::Vector2d>());
  }
  if (polygon.size() < 3) zone.fail("needs an `outline` of at least three points [x, y]");
  if (polygon.size() > kMaxCorners) zone.fail("an outline of more than 1000 points; give fewer");
  if (crosses_itself(polygon)) {
    zone.find("outline")->fail("crosses itself; give its corners in order, each once");
  }
  if (area(polygon) < 1e-6) zone.find("outline")->fail("has no area; its points are on one line");
  return polygon;
}

/// Reads `slip_zones`: polygons of the floor on which wheels turn further than the robot moves,
/// each with `outline` and `slip`. A self-intersecting outline is an error.
std::vector<sim::SlipZone> read_slip_zones(YamlReader& root) {
  std::vector<sim::SlipZone> zones;
  std::set<std::string> names;
  for (YamlReader zone : root.list("slip_zones")) {
    sim::SlipZone read;
    read.name = zone.get("name", fmt::format("slip-{}", zones.size()));
    if (!names.insert(read.name).second) {
      zone.fail("the name '" + read.name + "' is taken; every zone needs its own");
    }
    read.outline = read_outline(zone);
    read.slip = zone.get("slip", read.slip);
    if (!(read.slip >= 0.0 && read.slip < 1.0)) {
      zone.find("slip")->fail("is the share of the way that is lost: from 0 to below 1");
    }
    zones.push_back(std::move(read));
  }
  return zones;
}

constexpr double kMaxWorldSide = 1000.0;  // [m]

void read_extent(YamlReader extent, sim::WorldSpec& spec) {
  spec.min_corner = extent.require<Eigen::Vector2d>("min");
  spec.max_corner = extent.require<Eigen::Vector2d>("max");
  const Eigen::Vector2d size = spec.max_corner - spec.min_corner;
  if (size.minCoeff() <= 0.0) extent.fail("max must lie above and to the right of min");
  if (size.maxCoeff() > kMaxWorldSide) {
    extent.fail(fmt::format("{} m x {} m: at most 1000 m either way; lengths are in metres",
                            size.x(), size.y()));
  }
}

bool is_inside(const sim::WorldSpec& spec, const Eigen::Vector2d& p) {
  return (p.array() >= spec.min_corner.array()).all() &&
         (p.array() <= spec.max_corner.array()).all();
}

sim::Pose2 read_start(YamlReader& root, const sim::WorldSpec& spec) {
  const auto start = root.get<Eigen::Vector3d>("start", Eigen::Vector3d::Zero());
  if (!is_inside(spec, start.head<2>())) {
    const std::string message =
        fmt::format("the start ({}, {}) is outside of the extent; give `start: [x, y, yaw]`",
                    start.x(), start.y());
    root.find("start")->fail(message);
  }
  return {start.x(), start.y(), start.z()};
}

void read_objects(YamlReader& root, const std::filesystem::path& folder, sim::WorldSpec& spec) {
  std::set<std::string> names;
  std::size_t index = 0;
  for (YamlReader entry : root.list("objects")) {
    Bodies read = read_world_object(entry, index++, folder);
    for (sim::WorldObject& object : read.bodies) {
      if (!names.insert(object.name).second) {
        entry.fail("the name '" + object.name + "' is taken; every object needs its own");
      }
      spec.objects.push_back(std::move(object));
    }
    if (spec.objects.size() > kMaxBodies) {
      entry.fail(fmt::format("more than {} bodies in the world; leave some out", kMaxBodies));
    }
    std::move(read.doors.begin(), read.doors.end(), std::back_inserter(spec.doors));
  }
}

std::vector<Eigen::Vector2d> read_route(const YamlReader& route, const sim::WorldSpec& spec) {
  std::vector<Eigen::Vector2d> points;
  for (const YamlReader& point : route.items()) {
    points.push_back(point.as<Eigen::Vector2d>());
    if (!is_inside(spec, points.back())) point.fail("is outside of the world's extent");
  }
  if (points.size() < 2) route.fail("a route needs at least two points [x, y]");
  return points;
}

}  // namespace

WorldFile load_world(const std::filesystem::path& path) {
  const auto file = std::filesystem::is_directory(path) ? path / "world.yaml" : path;
  YamlDocument document = YamlDocument::load(file);
  YamlReader root = document.root();
  WorldFile world;
  world.spec.name = root.require<std::string>("name");
  require_name(root, "name", world.spec.name);
  read_extent(root.child("extent"), world.spec);
  world.start = read_start(root, world.spec);
  world.spec.inside = world.start.position();
  if (const auto map = root.get_optional<std::string>("map")) {
    world.map = file.parent_path() / *map;
  }
  world.spec.levels = root.get("levels", false);
  read_objects(root, file.parent_path(), world.spec);
  YamlReader routes = root.child("routes");
  for (const auto& [name, route] : routes.entries()) {
    world.routes[name] = read_route(route, world.spec);
  }
  world.spec.slip_zones = read_slip_zones(root);
  world.differences = read_differences(root, file.parent_path());
  document.reject_unknown_keys();
  return world;
}

}  // namespace castaway::testbed
