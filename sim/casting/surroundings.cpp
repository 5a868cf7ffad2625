#include "sim/casting/surroundings.hpp"

#include <algorithm>

namespace castaway::sim {
namespace {

/// Where a ray meets the floor, z = 0.
double distance_to_floor(const Ray& ray) {
  return ray.direction.z() < 0.0 ? std::max(-ray.origin.z() / ray.direction.z(), 0.0) : kNoHit;
}

}  // namespace

std::optional<RayHit> cast(const Surroundings& around, const Ray& ray, double max_distance,
                           std::uint32_t guess) {
  std::optional<RayHit> hit = around.fixed.cast(ray, max_distance, guess);
  if (around.moving == nullptr) return hit;
  std::optional<RayHit> nearer = around.moving->cast(ray, hit ? hit->distance : max_distance);
  if (!nearer) return hit;
  if (hit) nearer->primitive = hit->primitive;
  return nearer;
}

Echo first_echo(const Surroundings& around, const Ray& ray, double max_distance,
                std::uint32_t guess) {
  const double floor = distance_to_floor(ray);
  const auto hit = cast(around, ray, std::min(max_distance, floor), guess);
  if (hit) return {hit->distance, hit->object, hit->primitive, 1.0, 0.0, true};
  if (floor > max_distance) return {kNoHit, kHitNothing, guess};
  return {floor, kHitFloor, kNoPrimitive, 1.0, 0.0, true};
}

}  // namespace castaway::sim
