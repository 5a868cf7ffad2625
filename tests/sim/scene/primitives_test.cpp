#include "sim/scene/primitives.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(RaisePoint, KeepsXAndY) {
  EXPECT_EQ(raise_point({1.5, -2.0}, 0.25), Eigen::Vector3f(1.5F, -2.0F, 0.25F));
}

constexpr double kPi = std::numbers::pi;

/// Volume by the divergence theorem: positive if triangles are counter-clockwise seen from outside.
double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Eigen::Vector3d a = mesh.vertices.at(mesh.indices[i]).cast<double>();
    const Eigen::Vector3d b = mesh.vertices.at(mesh.indices[i + 1]).cast<double>();
    const Eigen::Vector3d c = mesh.vertices.at(mesh.indices[i + 2]).cast<double>();
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

void expect_outward_unit_normals(const TriangleMesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_NEAR(mesh.normals[i].norm(), 1.0F, 1e-5F);
    EXPECT_GT(mesh.normals[i].dot(mesh.vertices[i]), 0.0F);
  }
}

TEST(Primitives, BoxEnclosesItsVolume) {
  const TriangleMesh box = box_mesh({1.0F, 2.0F, 3.0F});
  EXPECT_EQ(box.indices.size(), 36U);
  EXPECT_NEAR(volume(box), 6.0, 1e-6);
  expect_outward_unit_normals(box);
}

TEST(Primitives, CylinderEnclosesItsPrism) {
  const int n = 24;
  const TriangleMesh cylinder = cylinder_mesh(0.5F, 2.0F, n);
  EXPECT_NEAR(volume(cylinder), 2.0 * 0.5 * n * 0.25 * std::sin(2.0 * kPi / n), 1e-5);
  expect_outward_unit_normals(cylinder);
}

TEST(Primitives, SphereComesNearItsVolume) {
  const TriangleMesh sphere = sphere_mesh(0.5F, 32);
  const double exact = 4.0 / 3.0 * kPi * 0.125;
  EXPECT_LT(volume(sphere), exact);
  EXPECT_GT(volume(sphere), 0.99 * exact);
  expect_outward_unit_normals(sphere);
}

TEST(Primitives, GroundAndArrowFaceUp) {
  for (const TriangleMesh& flat :
       {ground_mesh({-1.0F, 2.0F}, {3.0F, 4.0F}), arrow_mesh(0.5F, 0.2F)}) {
    for (std::size_t i = 0; i < flat.indices.size(); i += 3) {
      const Eigen::Vector3f a = flat.vertices[flat.indices[i]];
      const Eigen::Vector3f b = flat.vertices[flat.indices[i + 1]];
      const Eigen::Vector3f c = flat.vertices[flat.indices[i + 2]];
      EXPECT_GT((b - a).cross(c - a).z(), 0.0F);
      EXPECT_EQ(a.z(), 0.0F);
    }
  }
}

}  // namespace
}  // namespace castaway::sim
