#include "localization/sensor/ray_consistency.hpp"

#include <algorithm>
#include <iterator>

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

/// The beams in a volume, beam `i` made longer by `longer(i)` [m].
template <typename Longer>
std::vector<Ray> rays_in_volume(const PoseInVolume& pose, const ScanPoints& points,
                                std::span<const std::size_t> beams, const Longer& longer) {
  std::vector<Ray> rays;
  rays.reserve(beams.size());
  for (const std::size_t i : beams) {
    const Eigen::Vector3f from = pose.origin(points, i);
    const Eigen::Vector3f to = pose.end(points, i);
    const float stretch = 1.0F + static_cast<float>(longer(i)) / points.range[i];
    rays.push_back({from, from + stretch * (to - from)});
  }
  return rays;
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

/// How long before the end of a beam walls are ignored. [m]
double RayConsistency::margin(double range) const {
  return std::max(config_.margin, config_.margin_share * range);
}

/// Those beams whose margins are shorter than they.
std::vector<std::size_t> RayConsistency::beyond_margin(const ScanPoints& points,
                                                       std::span<const std::size_t> beams) const {
  std::vector<std::size_t> beyond;
  std::ranges::copy_if(beams, std::back_inserter(beyond), [&](std::size_t i) {
    const double r = points.range[i];
    return r > margin(r);
  });
  return beyond;
}

std::vector<std::size_t> RayConsistency::through_wall(const ScanPoints& points,
                                                      std::span<const std::size_t> beams) const {
  std::vector<std::size_t> long_enough = beyond_margin(points, beams);
  const auto less = [&](std::size_t i) { return -margin(points.range[i]); };
  if (const auto* plane = std::get_if<OnPlane>(&view_)) {
    std::erase_if(long_enough, [&](std::size_t i) { return !meets(*plane, points, i, less(i)); });
    return long_enough;
  }
  const auto& [volume, pose] = std::get<InVolume>(view_);
  if (!pose) return {};
  const std::vector<Ray> rays = rays_in_volume(*pose, points, long_enough, less);
  // A beam from a right pose may graze the ground, and passes along a wall before it ends there:
  // only one that leaves what is not ground has passed it.
  std::vector<std::size_t> through = passing_through(volume->walls(), rays);
  for (std::size_t& i : through) i = long_enough[i];
  return through;
}

std::vector<std::size_t> RayConsistency::ends_before_wall(const ScanPoints& points,
                                                          std::span<const std::size_t> beams,
                                                          double beyond) const {
  std::vector<std::size_t> ends(beams.begin(), beams.end());
  if (const auto* plane = std::get_if<OnPlane>(&view_)) {
    std::erase_if(ends, [&](std::size_t i) { return meets(*plane, points, i, beyond); });
    return ends;
  }
  const auto& [volume, pose] = std::get<InVolume>(view_);
  if (!pose) return ends;
  const std::vector<Ray> rays =
      rays_in_volume(*pose, points, beams, [&](std::size_t) { return beyond; });
  const std::vector<Encounter> met = encounters(volume->surfaces(), rays);
  ends.clear();
  for (std::size_t k = 0; k < beams.size(); ++k) {
    if (met[k] == Encounter::kNone) ends.push_back(beams[k]);
  }
  return ends;
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

}  // namespace castaway::localization
