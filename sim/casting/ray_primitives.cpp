#include "sim/casting/ray_shapes.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/ramp.hpp"

namespace castaway::sim {
namespace {

std::vector<RayShape> shapes_of(const BoxShape& box) { return {RayBox{0.5 * box.size}}; }

std::vector<RayShape> shapes_of(const CylinderShape& cylinder) {
  return {RayCylinder{cylinder.radius, 0.5 * cylinder.height}};
}

std::vector<RayShape> shapes_of(const SphereShape& sphere) { return {RaySphere{sphere.radius}}; }

std::vector<RayShape> shapes_of(const RampShape& ramp) {
  std::vector<RayShape> triangles;
  for (const RampTriangle& t : ramp_triangles(ramp)) {
    triangles.emplace_back(RayTriangle{t[0], t[1], t[2]});
  }
  return triangles;
}

std::vector<RayShape> shapes_of(const MeshShape& shape) {
  const TriangleMesh mesh = load_mesh(shape.path, shape.scale);
  const auto vertex = [&mesh](std::size_t i) -> Eigen::Vector3d {
    return mesh.vertices[mesh.indices[i]].cast<double>();
  };
  std::vector<RayShape> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    triangles.emplace_back(RayTriangle{vertex(i), vertex(i + 1), vertex(i + 2)});
  }
  return triangles;
}

}  // namespace

std::vector<RayPrimitive> ray_primitives(const WorldSpec& world) {
  std::vector<RayPrimitive> primitives;
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const WorldObject& object = world.objects[i];
    if (!object.in_world) continue;
    const auto shapes = std::visit([](const auto& s) { return shapes_of(s); }, object.shape);
    for (const RayShape& shape : shapes) {
      primitives.push_back({shape, object.T_map_object, static_cast<int>(i)});
    }
  }
  return primitives;
}

}  // namespace castaway::sim
