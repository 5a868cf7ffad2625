// Walls, windows and glass panes of world files.
#include <cmath>

#include "tools/scenario/world/object_reader.hpp"

namespace castaway::testbed {
namespace {

using Polyline = std::vector<Eigen::Vector2d>;

/// Cross-section of a wall's segments [m].
struct WallProfile {
  double thickness;
  double height;
  double bottom;
};

/// A box along the segment, extended by half the thickness at each end that is a corner.
sim::WorldObject wall_segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                              bool corner_from, bool corner_to, const WallProfile& wall) {
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d begin = from - along * (corner_from ? 0.5 * wall.thickness : 0.0);
  const Eigen::Vector2d end = to + along * (corner_to ? 0.5 * wall.thickness : 0.0);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << 0.5 * (begin + end), wall.bottom + 0.5 * wall.height;
  T.rotate(Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Eigen::Vector3d::UnitZ()));
  return body(sim::BoxShape{{(end - begin).norm(), wall.thickness, wall.height}}, T);
}

Polyline points_of(YamlReader& reader) {
  Polyline points;
  for (const YamlReader& point : reader.list("points")) {
    points.push_back(point.as<Eigen::Vector2d>());
    const std::size_t n = points.size();
    if (n > 1 && points[n - 1] == points[n - 2]) point.fail("the same point twice");
  }
  return points;
}

Bodies along(const Polyline& points, bool closed, const WallProfile& wall) {
  Bodies result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const bool is_last = i + 2 == points.size();
    result.bodies.push_back(
        wall_segment(points[i], points[i + 1], closed || i > 0, closed || !is_last, wall));
  }
  if (closed) {
    result.bodies.push_back(wall_segment(points.back(), points.front(), true, true, wall));
  }
  return result;
}

Bodies read_polyline(YamlReader& reader, const char* kind, const WallProfile& standard) {
  const Polyline points = points_of(reader);
  const bool closed = reader.get("closed", false);
  const WallProfile wall{positive(reader, "thickness", standard.thickness),
                         positive(reader, "height", standard.height),
                         reader.get("bottom", standard.bottom)};
  if (points.size() < (closed ? 3U : 2U)) {
    reader.fail(std::string("a ") + kind + " needs `points`: 2, or 3 if closed");
  }
  return along(points, closed, wall);
}

}  // namespace

Bodies read_wall(YamlReader& reader) { return read_polyline(reader, "wall", {0.1, 2.4, 0.0}); }

Bodies read_glass(YamlReader& reader) {
  Bodies panes = read_polyline(reader, "pane", {0.02, 2.0, 0.0});
  for (sim::WorldObject& pane : panes.bodies) pane.surface.glass = true;
  return panes;
}

Bodies read_window(YamlReader& reader) {
  const Polyline points{reader.require<Eigen::Vector2d>("from"),
                        reader.require<Eigen::Vector2d>("to")};
  if (points[0] == points[1]) reader.fail("'from' and 'to' are the same point");
  const double thickness = positive(reader, "thickness", 0.1);
  const double sill = positive(reader, "sill", 0.9);
  const double height = positive(reader, "height", 2.4);
  if (sill >= height) reader.find("sill")->fail("must be below the window's upper edge, 'height'");
  Bodies window = along(points, false, {thickness, sill, 0.0});
  Bodies pane = along(points, false, {0.02, height - sill, sill});
  pane.bodies.front().surface.glass = true;
  window.bodies.push_back(pane.bodies.front());
  return window;
}

}  // namespace castaway::testbed
