#include "sim/casting/ray_scene.hpp"

#include <utility>

namespace castaway::sim {
namespace {

constexpr int kNoBody = -1;

BoxTree tree_of(const std::vector<RayPrimitive>& primitives) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const RayPrimitive& primitive : primitives) boxes.push_back(bounds(primitive));
  return BoxTree(boxes);
}

}  // namespace

RayScene::RayScene(std::vector<RayPrimitive> primitives)
    : primitives_(std::move(primitives)), tree_(tree_of(primitives_)) {
  std::vector<RayPrimitive> ordered;
  ordered.reserve(primitives_.size());
  for (const std::uint32_t index : tree_.order()) ordered.push_back(primitives_[index]);
  primitives_ = std::move(ordered);
}

std::optional<RayHit> RayScene::cast(const Ray& ray, double max_distance,
                                     std::uint32_t guess) const {
  RayHit nearest{max_distance, kNoBody, kNoPrimitive};
  const auto visit = [&](std::uint32_t i) {
    const double distance = intersect(primitives_[i], ray);
    if (distance < nearest.distance) nearest = {distance, primitives_[i].object, i};
  };
  if (guess < primitives_.size()) visit(guess);
  tree_.walk(ray, nearest.distance, [&](std::uint32_t i) {
    if (i != guess) visit(i);
    return nearest.distance;
  });
  if (nearest.object == kNoBody) return std::nullopt;
  return nearest;
}

}  // namespace castaway::sim
