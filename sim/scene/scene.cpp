#include "sim/scene/scene.hpp"

#include <algorithm>

namespace castaway::sim {

Eigen::AlignedBox3f bounds_of(const SceneItem& item) {
  Eigen::AlignedBox3f own;
  for (const Eigen::Vector3f& vertex : item.mesh.vertices) own.extend(vertex);
  return own.isEmpty() ? own : own.transformed(item.T_map_mesh);
}

Eigen::AlignedBox3f lit_bounds(const Scene& scene) {
  Eigen::AlignedBox3f bounds;
  for (const SceneItem& item : scene.items) {
    if (item.shaded) bounds.extend(bounds_of(item));
  }
  return bounds;
}

float standing_height(const std::vector<SceneItem>& items) {
  float height = 0.0F;
  for (const SceneItem& item : items) {
    const Eigen::AlignedBox3f bounds = bounds_of(item);
    if (item.casts_shadow && !bounds.isEmpty()) height = std::max(height, bounds.max().z());
  }
  return height;
}

}  // namespace castaway::sim
