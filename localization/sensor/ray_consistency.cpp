#include "localization/sensor/ray_consistency.hpp"

#include <algorithm>

#include "localization/volume/voxel_rays.hpp"

namespace castaway::localization {
namespace {

/// A ray in cells: `length` from `from` along the unit vector `direction`.
struct CellRay {
  Eigen::Vector2f from;
  Eigen::Vector2f direction;
  float length;
};

bool ray_meets_wall(const CellRay& ray, const WallClearance& walls) {
  const GridFrame& frame = walls.frame();
  const auto width = static_cast<float>(frame.width);
  const auto height = static_cast<float>(frame.height);
  bool inside = true;  // Still inside of the object in which the ray starts.
  for (float t = 0.0F; t < ray.length;) {
    const float x = ray.from.x() + t * ray.direction.x();
    const float y = ray.from.y() + t * ray.direction.y();
    if (!(x >= 0.0F && y >= 0.0F && x < width && y < height)) return false;
    const int clear = walls.half_cells(static_cast<int>(x), static_cast<int>(y));
    if (clear == 0 && !inside) return true;
    if (clear > 0) inside = false;
    t += 0.5F * static_cast<float>(std::max(clear - 2, 1));
  }
  return false;
}

}  // namespace

RayConsistency::RayConsistency(const RayWorld& world, const SE2& T_map_base,
                               const RayConsistencyConfig& config)
    : view_(view_from(world, T_map_base)), config_(config) {}

RayConsistency::View RayConsistency::view_from(const RayWorld& world, const SE2& T_map_base) {
  if (const auto* walls = std::get_if<const WallClearance*>(&world)) {
    return OnPlane{*walls, PoseInCells((*walls)->frame(), T_map_base)};
  }
  const Volume* volume = std::get<const Volume*>(world);
  InVolume view{volume, std::nullopt};
  if (const auto there = volume->lift(T_map_base)) view.pose.emplace(there->T_map_base);
  return view;
}

bool RayConsistency::through_wall(const ScanPoints& points, std::size_t i) const {
  const double r = points.range[i];
  const double margin = std::max(config_.margin, config_.margin_share * r);
  return r > margin && meets_wall(points, i, -margin);
}

bool RayConsistency::ends_before_wall(const ScanPoints& points, std::size_t i,
                                      double beyond) const {
  return !meets_wall(points, i, beyond);
}

/// True if beam `i`, made longer by `longer` [m], meets a wall.
bool RayConsistency::meets_wall(const ScanPoints& points, std::size_t i, double longer) const {
  return std::visit([&](const auto& view) { return meets(view, points, i, longer); }, view_);
}

bool RayConsistency::meets(const OnPlane& view, const ScanPoints& points, std::size_t i,
                           double longer) {
  const auto scale = static_cast<float>(1.0 / view.walls->frame().resolution);
  const PoseInCells& pose = view.pose;
  const float r = points.range[i];
  const Eigen::Vector2f from(pose.x(points.origin_x[i], points.origin_y[i]),
                             pose.y(points.origin_x[i], points.origin_y[i]));
  const Eigen::Vector2f to(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i]));
  const float length = (r + static_cast<float>(longer)) * scale;
  return ray_meets_wall({from, (to - from) / (r * scale), length}, *view.walls);
}

/// A beam from a right pose may graze the ground, and passes along a wall before it ends there:
/// only one that leaves what is not ground has passed it. One that is made longer need not.
bool RayConsistency::meets(const InVolume& view, const ScanPoints& points, std::size_t i,
                           double longer) {
  if (!view.pose) return false;
  const Eigen::Vector3f from = view.pose->origin(points, i);
  const Eigen::Vector3f to = view.pose->end(points, i);
  const float stretch = 1.0F + static_cast<float>(longer) / points.range[i];
  const Volume& volume = *view.volume;
  const Eigen::Vector3f end = from + stretch * (to - from);
  if (longer > 0.0) return encounter(volume.surfaces(), from, end) != Encounter::kNone;
  return passes_through(volume.walls(), from, end);
}

}  // namespace castaway::localization
