#include "sim/world/world_visuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/render/primitives.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/ramp.hpp"

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

constexpr float kRoofAbove = 1.5F;   // [m]
constexpr float kRoofShare = 0.25F;  // Of the world's extent.
constexpr float kLevel = 0.7F;       // Of a unit normal, along z.

/// Removes the level faces above `kRoofAbove` of a mesh that has much of them.
void remove_roof(SceneItem& item, float extent) {
  const TriangleMesh& mesh = item.mesh;
  std::vector<std::uint32_t> kept;
  float roof = 0.0F;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Eigen::Vector3f a = item.T_map_mesh * mesh.vertices[mesh.indices[i]];
    const Eigen::Vector3f b = item.T_map_mesh * mesh.vertices[mesh.indices[i + 1]];
    const Eigen::Vector3f c = item.T_map_mesh * mesh.vertices[mesh.indices[i + 2]];
    const Eigen::Vector3f normal = (b - a).cross(c - a);
    const bool high = std::min({a.z(), b.z(), c.z()}) > kRoofAbove;
    if (high && std::abs(normal.z()) > kLevel * normal.norm()) {
      roof += 0.5F * std::abs(normal.z());
    } else {
      kept.insert(kept.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    }
  }
  if (roof > kRoofShare * extent) item.mesh.indices = std::move(kept);
}

}  // namespace

std::vector<SceneItem> world_visuals_from_above(const WorldSpec& world) {
  std::vector<SceneItem> items = world_visuals(world);
  const auto extent = static_cast<float>((world.max_corner - world.min_corner).prod());
  for (SceneItem& item : items) remove_roof(item, extent);
  std::erase_if(items, [](const SceneItem& item) { return item.mesh.indices.empty(); });
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
  return items;
}

}  // namespace castaway::sim
