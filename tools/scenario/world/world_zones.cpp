#include "tools/scenario/world/world_zones.hpp"

#include <set>

#include <fmt/format.h>

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

}  // namespace

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

}  // namespace castaway::testbed
