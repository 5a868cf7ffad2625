#include "sim/difference/room_check.hpp"

#include <algorithm>
#include <cmath>

#include "sim/common/cell_index.hpp"
#include "sim/map/grid_tools.hpp"
#include "sim/world/footprint.hpp"

namespace castaway::sim {
namespace {

constexpr double kGap = 0.03;        // [m] Least distance between two objects.
constexpr double kRouteRoom = 0.45;  // [m] Kept free on each side of a route.
constexpr double kStartRoom = 0.6;   // [m]
constexpr double kDoorRoom = 0.8;    // [m] Kept free around the middle of an opening.
constexpr double kRouteStep = 0.05;  // [m] Between points of routes.

std::vector<Eigen::Vector2d> points_along(const std::vector<Eigen::Vector2d>& route) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d& from = route[i];
    const Eigen::Vector2d& to = route[(i + 1) % route.size()];
    const int steps = cell_index(std::ceil((to - from).norm() / kRouteStep));
    for (int k = 0; k < steps; ++k) points.emplace_back(from + (to - from) * k / steps);
  }
  return points;
}

/// Bounds of an outline, grown on all sides.
Eigen::AlignedBox2d grow_bounds(const ConvexOutline& outline, double by) {
  Eigen::AlignedBox2d box = bounds(outline);
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(by);
  return {box.min() - margin, box.max() + margin};
}

/// The outline with its corners moved away from its middle, each by at least `by`.
ConvexOutline inflate(const ConvexOutline& outline, double by) {
  const Eigen::Vector2d center = bounds(outline).center();
  ConvexOutline result;
  for (const Eigen::Vector2d& p : outline.points) {
    const double length = (p - center).norm();
    result.points.emplace_back(p + (p - center) * (1.5 * by / std::max(length, by)));
  }
  return result;
}

}  // namespace

RoomCheck::RoomCheck(const WorldSpec& world, const Grid& map, const KeepClear& keep)
    : map_(map), start_(keep.start) {
  for (std::size_t i = 0; i < world.objects.size(); ++i) update(world, i);
  for (const auto& route : keep.routes) {
    const auto points = points_along(route);
    way_.insert(way_.end(), points.begin(), points.end());
  }
  for (const Door& door : world.doors) {
    const Eigen::Vector3d middle =
        door.T_map_hinge * Eigen::Vector3d(0.5 * door.leaf.x(), 0.0, 0.0);
    doors_.emplace_back(middle.head<2>());
  }
}

void RoomCheck::update(const WorldSpec& world, std::size_t object) {
  if (standing_.size() <= object) standing_.resize(object + 1);
  const WorldObject& o = world.objects[object];
  if (!o.in_world) {
    standing_[object] = {};
    return;
  }
  const ConvexOutline outline = footprint(o);
  standing_[object] = {true, o.movable, outline, bounds(outline)};
}

bool RoomCheck::passable(const ConvexOutline& outline) const {
  const Eigen::AlignedBox2d near = grow_bounds(outline, kStartRoom);
  if (start_ && distance(outline, *start_) < kStartRoom) return false;
  return std::none_of(way_.begin(), way_.end(), [&](const Eigen::Vector2d& p) {
    return near.contains(p) && distance(outline, p) < kRouteRoom;
  });
}

bool RoomCheck::is_known(const ConvexOutline& outline) const {
  return std::all_of(outline.points.begin(), outline.points.end(),
                     [&](const Eigen::Vector2d& p) { return cell_at(map_, p) != Cell::kUnknown; });
}

bool RoomCheck::fits(const std::vector<ConvexOutline>& outlines,
                     const std::vector<std::size_t>& except) const {
  for (const ConvexOutline& outline : outlines) {
    if (!is_known(outline) || !passable(outline)) return false;
    const auto blocks = [&](const auto& door) { return distance(outline, door) < kDoorRoom; };
    if (std::any_of(doors_.begin(), doors_.end(), blocks)) return false;
    const ConvexOutline wide = inflate(outline, kGap);
    const Eigen::AlignedBox2d near = bounds(wide);
    for (std::size_t i = 0; i < standing_.size(); ++i) {
      if (!standing_[i].there || !near.intersects(standing_[i].box)) continue;
      if (std::find(except.begin(), except.end(), i) != except.end()) continue;
      if (overlap(wide, standing_[i].outline)) return false;
    }
  }
  return true;
}

bool RoomCheck::leaf_fits(const ConvexOutline& leaf) const {
  return passable(leaf) &&
         std::none_of(standing_.begin(), standing_.end(), [&](const Standing& other) {
           return other.there && other.movable && overlap(leaf, other.outline);
         });
}

}  // namespace castaway::sim
