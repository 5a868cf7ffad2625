#include "sim/world/world_visuals.hpp"

#include <algorithm>
#include <utility>

#include "sim/scene/primitives.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/ramp.hpp"
#include "sim/world/roof.hpp"

namespace castaway::sim {
namespace {

TriangleMesh mesh_of(const BoxShape& box) { return box_mesh(box.size.cast<float>()); }
TriangleMesh mesh_of(const CylinderShape& c) {
  return cylinder_mesh(static_cast<float>(c.radius), static_cast<float>(c.height));
}
TriangleMesh mesh_of(const SphereShape& s) { return sphere_mesh(static_cast<float>(s.radius)); }
TriangleMesh mesh_of(const RampShape& ramp) {
  TriangleMesh mesh;
  for (const RampTriangle& t : ramp_triangles(ramp)) {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    for (const Eigen::Vector3d& p : t) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.emplace_back(p.cast<float>());
      mesh.normals.emplace_back(normal.cast<float>());
    }
  }
  return mesh;
}
TriangleMesh mesh_of(const MeshShape& shape) { return load_mesh(shape.path, shape.scale); }

}  // namespace

std::vector<SceneItem> world_visuals_from_above(const WorldSpec& world) {
  std::vector<SceneItem> items = world_visuals(world);
  std::erase_if(items, [](const SceneItem& item) { return !item.casts_shadow; });
  return items;
}

TriangleMesh shape_mesh(const ObjectShape& shape) {
  return std::visit([](const auto& kind) { return mesh_of(kind); }, shape);
}

std::vector<SceneItem> world_visuals(const WorldSpec& world) {
  std::vector<SceneItem> items;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const WorldObject& object = world.objects[i];
    if (!object.in_world) continue;
    SceneItem item;
    item.instance = static_cast<std::uint16_t>(
        std::min<std::size_t>(kFirstObjectInstance + i, kFirstPersonInstance - 1));
    item.mesh = shape_mesh(object.shape);
    item.T_map_mesh = object.T_map_object.cast<float>();
    item.color = object.color;
    items.push_back(std::move(item));
  }
  const Eigen::Vector2d size = world.max_corner - world.min_corner;
  return split_roofs(std::move(items), static_cast<float>(size.prod()));
}

}  // namespace castaway::sim
