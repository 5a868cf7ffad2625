#include "sim/scene/primitives.hpp"

#include <cmath>
#include <numbers>

namespace castaway::sim {
namespace {

using Eigen::Vector3f;

constexpr float kPi = std::numbers::pi_v<float>;

std::uint32_t add_vertex(TriangleMesh& mesh, const Vector3f& vertex, const Vector3f& normal) {
  mesh.vertices.push_back(vertex);
  mesh.normals.push_back(normal);
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_triangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// A parallelogram about `center`, counter-clockwise seen from the side of u x v.
void add_quad(TriangleMesh& mesh, const Vector3f& center, const Vector3f& u, const Vector3f& v) {
  const Vector3f normal = u.cross(v).normalized();
  const std::uint32_t first = add_vertex(mesh, center - u - v, normal);
  add_vertex(mesh, center + u - v, normal);
  add_vertex(mesh, center + u + v, normal);
  add_vertex(mesh, center - u + v, normal);
  add_triangle(mesh, first, first + 1, first + 2);
  add_triangle(mesh, first, first + 2, first + 3);
}

Vector3f on_circle(int segment, int segments) {
  const float angle = 2.0F * kPi * static_cast<float>(segment) / static_cast<float>(segments);
  return {std::cos(angle), std::sin(angle), 0.0F};
}

/// A disc facing `up` (+1 or -1) at height z.
void add_disc(TriangleMesh& mesh, float radius, float z, float up, int segments) {
  const Vector3f normal(0.0F, 0.0F, up);
  const Vector3f center(0.0F, 0.0F, z);
  const std::uint32_t middle = add_vertex(mesh, center, normal);
  for (int i = 0; i <= segments; ++i) {
    const int turned = up > 0.0F ? i : segments - i;
    const auto rim = add_vertex(mesh, center + radius * on_circle(turned, segments), normal);
    if (i > 0) add_triangle(mesh, middle, rim - 1, rim);
  }
}

}  // namespace

TriangleMesh box_mesh(const Vector3f& size) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      const Vector3f u = 0.5F * size((axis + 1) % 3) * Vector3f::Unit((axis + 1) % 3);
      const Vector3f v = 0.5F * size((axis + 2) % 3) * Vector3f::Unit((axis + 2) % 3);
      add_quad(mesh, sign * 0.5F * size(axis) * Vector3f::Unit(axis), u, sign * v);
    }
  }
  return mesh;
}

TriangleMesh cylinder_mesh(float radius, float height, int segments) {
  TriangleMesh mesh;
  const Vector3f half(0.0F, 0.0F, 0.5F * height);
  for (int i = 0; i <= segments; ++i) {
    const Vector3f out = on_circle(i, segments);
    const std::uint32_t low = add_vertex(mesh, radius * out - half, out);
    const std::uint32_t high = add_vertex(mesh, radius * out + half, out);
    if (i == 0) continue;
    add_triangle(mesh, low - 2, low, high);
    add_triangle(mesh, low - 2, high, high - 2);
  }
  add_disc(mesh, radius, half.z(), 1.0F, segments);
  add_disc(mesh, radius, -half.z(), -1.0F, segments);
  return mesh;
}

TriangleMesh sphere_mesh(float radius, int rings) {
  TriangleMesh mesh;
  const int sectors = 2 * rings;
  for (int ring = 0; ring <= rings; ++ring) {
    const float polar = kPi * static_cast<float>(ring) / static_cast<float>(rings);
    for (int sector = 0; sector <= sectors; ++sector) {
      Vector3f out = std::sin(polar) * on_circle(sector, sectors);
      out.z() = std::cos(polar);
      const std::uint32_t here = add_vertex(mesh, radius * out, out);
      if (ring == 0 || sector == 0) continue;
      const std::uint32_t above = here - static_cast<std::uint32_t>(sectors + 1);
      add_triangle(mesh, above - 1, here - 1, here);
      add_triangle(mesh, above - 1, here, above);
    }
  }
  return mesh;
}

TriangleMesh ground_mesh(const Eigen::Vector2f& min_corner, const Eigen::Vector2f& max_corner) {
  TriangleMesh mesh;
  const Eigen::Vector2f center = 0.5F * (min_corner + max_corner);
  const Eigen::Vector2f half = 0.5F * (max_corner - min_corner);
  add_quad(mesh, {center.x(), center.y(), 0.0F}, half.x() * Vector3f::UnitX(),
           half.y() * Vector3f::UnitY());
  return mesh;
}

TriangleMesh arrow_mesh(float length, float width) {
  TriangleMesh mesh;
  const float shaft = 0.6F * length;
  const float half = 0.5F * width;
  const Vector3f up = Vector3f::UnitZ();
  add_quad(mesh, {0.5F * shaft, 0.0F, 0.0F}, 0.5F * shaft * Vector3f::UnitX(),
           0.4F * half * Vector3f::UnitY());
  const std::uint32_t base = add_vertex(mesh, {shaft, -half, 0.0F}, up);
  add_vertex(mesh, {length, 0.0F, 0.0F}, up);
  add_vertex(mesh, {shaft, half, 0.0F}, up);
  add_triangle(mesh, base, base + 1, base + 2);
  return mesh;
}

}  // namespace castaway::sim
