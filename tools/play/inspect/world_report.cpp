#include "tools/play/inspect/world_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/play/inspect/world_likeness.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTightRoute = 0.3;  // [m]

RouteFacts facts_of(const std::string& name, const std::vector<Eigen::Vector2d>& route,
                    const sim::FreeSpace& space) {
  RouteFacts facts{name, 0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d& from = route[i];
    const Eigen::Vector2d& to = route[(i + 1) % route.size()];
    const double length = (to - from).norm();
    facts.length += length;
    const int steps = static_cast<int>(length / 0.02) + 1;
    for (int k = 0; k <= steps; ++k) {
      const sim::CellIndex cell = sim::cell_of(space.grid(), from + (to - from) * k / steps);
      const bool inside = space.grid().contains(cell.column, cell.row);
      const double room =
          inside ? static_cast<double>(space.clearance()[sim::flat_index(space.grid(), cell)])
                 : 0.0;
      facts.clearance = std::min(facts.clearance, room);
    }
  }
  return facts;
}

void warn(const LoadedWorld& world, const sim::FreeSpace& space, WorldFacts& facts) {
  facts.warnings = world.warnings;
  for (const RouteFacts& route : facts.routes) {
    if (route.clearance >= kTightRoute) continue;
    facts.warnings.push_back(
        fmt::format("route {} passes within {:.2f} m of an obstacle", route.name, route.clearance));
  }
  if (world.has_start && !space.contains(world.file.start.position())) {
    facts.warnings.push_back(
        fmt::format("the start ({}, {}) is not free", world.file.start.x, world.file.start.y));
  }
  if (facts.ambiguity.places == 0) {
    facts.warnings.emplace_back("no free space for a robot: check the extent and the heights");
  }
}

using Json = nlohmann::ordered_json;
using Lines = std::back_insert_iterator<std::string>;

/// Numbers of objects by kind.
struct Counts {
  std::map<std::string, int> kinds;
  std::set<std::string> furniture;
  int glass = 0;
  int only_world = 0;
  int only_map = 0;
  int drivable = 0;
};

const char* kind_of(const sim::ObjectShape& shape) {
  constexpr std::array<const char*, 5> kNames = {"boxes", "cylinders", "meshes", "spheres",
                                                 "ramps"};
  return kNames[shape.index()];
}

Counts count(const sim::WorldSpec& world) {
  Counts counts;
  for (const sim::WorldObject& object : world.objects) {
    ++counts.kinds[kind_of(object.shape)];
    if (object.movable) counts.furniture.insert(object.piece.empty() ? object.name : object.piece);
    counts.glass += object.surface.glass ? 1 : 0;
    counts.only_world += object.in_map ? 0 : 1;
    counts.only_map += object.in_world ? 0 : 1;
    counts.drivable += object.drivable ? 1 : 0;
  }
  return counts;
}

double area(const std::vector<Eigen::Vector2d>& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(0.5 * twice);
}

int open_doors(const sim::WorldSpec& world) {
  int open = 0;
  for (const sim::Door& door : world.doors) open += std::abs(door.open_deg) > 10.0 ? 1 : 0;
  return open;
}

void add_objects(const sim::WorldSpec& world, Lines out) {
  const Counts counts = count(world);
  fmt::format_to(out, "bodies: {}", world.objects.size());
  const char* separator = " (";
  for (const auto& [kind, number] : counts.kinds) {
    fmt::format_to(out, "{}{} {}", separator, number, kind);
    separator = ", ";
  }
  fmt::format_to(out, "); {} of glass, {} to drive over\n", counts.glass, counts.drivable);
  fmt::format_to(out, "furniture: {} pieces; doors: {}, of these {} open\n",
                 counts.furniture.size(), world.doors.size(), open_doors(world));
  fmt::format_to(out, "not as mapped: {} bodies only in the world, {} only on the map\n",
                 counts.only_world, counts.only_map);
}

void add_floor(const LoadedWorld& world, const WorldFacts& facts, Lines out) {
  for (const sim::SlipZone& zone : world.file.spec.slip_zones) {
    fmt::format_to(out, "slip zone {}: {:.1f} m2, {:.0f} % lost\n", zone.name, area(zone.outline),
                   100.0 * zone.slip);
  }
  if (world.has_start) {
    fmt::format_to(out, "start: ({}, {}), yaw {} rad\n", world.file.start.x, world.file.start.y,
                   world.file.start.yaw);
  } else {
    fmt::format_to(out, "start: none; runs draw one\n");
  }
  for (const RouteFacts& route : facts.routes) {
    fmt::format_to(out, "route {}: {:.1f} m, {:.2f} m from the nearest obstacle\n", route.name,
                   route.length, route.clearance);
  }
}

Json zones_json(const sim::WorldSpec& world) {
  Json zones = Json::array();
  for (const sim::SlipZone& zone : world.slip_zones) {
    zones.push_back({{"name", zone.name}, {"area_m2", area(zone.outline)}, {"slip", zone.slip}});
  }
  return zones;
}

Json routes_json(const WorldFacts& facts) {
  Json routes = Json::array();
  for (const RouteFacts& route : facts.routes) {
    routes.push_back(
        {{"name", route.name}, {"length_m", route.length}, {"clearance_m", route.clearance}});
  }
  return routes;
}

Json objects_json(const sim::WorldSpec& world) {
  const Counts counts = count(world);
  Json json{{"bodies", world.objects.size()}};
  for (const auto& [kind, number] : counts.kinds) json[kind] = number;
  json["glass"] = counts.glass;
  json["drivable"] = counts.drivable;
  json["furniture"] = counts.furniture.size();
  json["doors"] = world.doors.size();
  json["doors_open"] = open_doors(world);
  json["only_in_world"] = counts.only_world;
  json["only_on_map"] = counts.only_map;
  return json;
}

}  // namespace

WorldFacts world_facts(const LoadedWorld& world, const sim::PlaceView& view) {
  WorldFacts facts;
  const auto free = std::count(world.grid.cells.begin(), world.grid.cells.end(), sim::Cell::kFree);
  facts.free_area = static_cast<double>(free) * world.grid.resolution * world.grid.resolution;
  const sim::FreeSpace way(obstacle_grid(world), kPlaceRadius);
  const sim::FreeSpace space = place_space(world);
  for (const auto& [name, route] : world.file.routes) {
    facts.routes.push_back(facts_of(name, route, way));
  }
  facts.change = sim::changed_beams(world.file.spec, world.grid, view);
  facts.ambiguity = sim::ambiguity_of(world_likeness(world, view));
  warn(world, space, facts);
  return facts;
}

std::string world_text(const LoadedWorld& world, const WorldFacts& facts) {
  std::string text;
  const Lines out(text);
  const sim::WorldSpec& spec = world.file.spec;
  const Eigen::Vector2d size = spec.max_corner - spec.min_corner;
  fmt::format_to(out, "world: {}, {:.1f} m x {:.1f} m from ({:.2f}, {:.2f}), {:.1f} m2 free\n",
                 spec.name, size.x(), size.y(), spec.min_corner.x(), spec.min_corner.y(),
                 facts.free_area);
  add_objects(spec, out);
  add_floor(world, facts, out);
  fmt::format_to(out,
                 "difference: {:.2f} % of the beams end elsewhere than on the map by more than "
                 "0.2 m ({:.2f} % by 0.1 m), from {} places\n",
                 100.0 * facts.change.share, 100.0 * facts.change.share_fine, facts.change.places);
  const sim::Ambiguity& a = facts.ambiguity;
  fmt::format_to(out,
                 "ambiguity: likeness to the best match elsewhere {:.3f} in the mean, p90 {:.3f}; "
                 "{:.1f} % of {} places have a twin\n",
                 a.mean, a.p90, 100.0 * a.twins, a.places);
  for (const std::string& warning : facts.warnings) text += "warning: " + warning + "\n";
  return text;
}

nlohmann::ordered_json world_json(const LoadedWorld& world, const WorldFacts& facts) {
  const sim::WorldSpec& spec = world.file.spec;
  Json json{{"name", spec.name},
            {"min_m", {spec.min_corner.x(), spec.min_corner.y()}},
            {"max_m", {spec.max_corner.x(), spec.max_corner.y()}},
            {"free_area_m2", facts.free_area},
            {"objects", objects_json(spec)},
            {"slip_zones", zones_json(spec)}};
  const sim::Pose2& start = world.file.start;
  json["start"] = world.has_start ? Json{start.x, start.y, start.yaw} : Json();
  json["routes"] = routes_json(facts);
  json["difference"] = {{"beams", facts.change.share},
                        {"beams_0.1m", facts.change.share_fine},
                        {"places", facts.change.places}};
  const sim::Ambiguity& a = facts.ambiguity;
  json["ambiguity"] = {{"mean", a.mean}, {"p90", a.p90}, {"twins", a.twins}, {"places", a.places}};
  json["warnings"] = facts.warnings;
  return json;
}

}  // namespace castaway::testbed
