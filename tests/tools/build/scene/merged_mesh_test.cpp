#include "tools/build/scene/merged_mesh.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/scene/primitives.hpp"

namespace castaway::testbed {
namespace {

sim::SceneItem box_at(float x, const Eigen::Vector3f& color) {
  sim::SceneItem item;
  item.mesh = sim::box_mesh({1.0F, 2.0F, 3.0F});
  item.T_map_mesh.translation().x() = x;
  item.color = color;
  return item;
}

Eigen::AlignedBox3f bounds_of(const MergedMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : mesh.positions) box.extend(p);
  return box;
}

/// Surface of all triangles. [m2]
float area_of(const MergedMesh& mesh) {
  float area = 0.0F;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Eigen::Vector3f& a = mesh.positions[mesh.indices[i]];
    area += 0.5F * (mesh.positions[mesh.indices[i + 1]] - a)
                       .cross(mesh.positions[mesh.indices[i + 2]] - a)
                       .norm();
  }
  return area;
}

TEST(MergedMesh, PlacesItemsAndKeepsTheirColors) {
  const MergedMesh mesh = merge_items({box_at(0.0F, {1.0F, 0.5F, 0.0F}), box_at(5.0F, {0, 0, 1})});
  EXPECT_EQ(mesh.positions.size(), 48U);
  EXPECT_EQ(mesh.indices.size(), 72U);
  EXPECT_EQ(mesh.colors.front(), (std::array<std::uint8_t, 3>{255, 128, 0}));
  EXPECT_EQ(mesh.colors.back(), (std::array<std::uint8_t, 3>{0, 0, 255}));
  EXPECT_EQ(bounds_of(mesh).min(), Eigen::Vector3f(-0.5F, -1.0F, -1.5F));
  EXPECT_EQ(bounds_of(mesh).max(), Eigen::Vector3f(5.5F, 1.0F, 1.5F));
  EXPECT_FLOAT_EQ(area_of(mesh), 2 * 22.0F);
}

TEST(MergedMesh, NormalsTurnWithTheItem) {
  sim::SceneItem item = box_at(0.0F, {1, 1, 1});
  item.mesh = sim::ground_mesh({0.0F, 0.0F}, {1.0F, 1.0F});
  item.T_map_mesh.linear() =
      Eigen::AngleAxisf(0.5F * 3.14159265F, Eigen::Vector3f::UnitX()).toRotationMatrix();
  const MergedMesh mesh = merge_items({item});
  EXPECT_EQ(mesh.normals.front(), (std::array<std::int8_t, 3>{0, -127, 0}));
}

TEST(MergedMesh, ColorsOfCornersAreMultiplied) {
  sim::SceneItem item = box_at(0.0F, {0.5F, 1.0F, 1.0F});
  item.mesh.colors.assign(item.mesh.vertices.size(), {0.5F, 0.5F, 1.0F});
  EXPECT_EQ(merge_items({item}).colors.front(), (std::array<std::uint8_t, 3>{64, 128, 255}));
}

TEST(MergedMesh, EqualCornersBecomeOne) {
  sim::SceneItem item = box_at(0.0F, {1, 1, 1});
  const sim::TriangleMesh shared = item.mesh;
  item.mesh = {};
  for (const std::uint32_t index : shared.indices) {  // A triangle soup, as STL files have it.
    item.mesh.indices.push_back(static_cast<std::uint32_t>(item.mesh.vertices.size()));
    item.mesh.vertices.push_back(shared.vertices[index]);
    item.mesh.normals.push_back(shared.normals[index]);
  }
  const MergedMesh mesh = merge_items({item});
  EXPECT_EQ(mesh.positions.size(), 24U);
  EXPECT_EQ(mesh.indices.size(), 36U);
}

TEST(MergedMesh, AThinnedSphereIsSmallerAndStaysASphere) {
  sim::SceneItem ball;
  ball.mesh = sim::sphere_mesh(1.0F, 60);
  const MergedMesh whole = merge_items({ball});
  const MergedMesh thinned = merge_items({ball}, 0.2F);
  EXPECT_LT(thinned.indices.size(), whole.indices.size() / 4);
  EXPECT_GT(thinned.indices.size(), 300U);
  EXPECT_NEAR(area_of(thinned), area_of(whole), 0.1F * area_of(whole));
  for (const Eigen::Vector3f& p : thinned.positions) EXPECT_NEAR(p.norm(), 1.0F, 0.05F);
}

TEST(MergedMesh, BothSidesOfAThinWallAreKept) {
  sim::SceneItem wall;
  wall.mesh = sim::box_mesh({4.0F, 0.02F, 2.0F});
  const MergedMesh mesh = merge_items({wall}, 0.5F);
  EXPECT_FLOAT_EQ(bounds_of(mesh).sizes().y(), 0.02F);
  EXPECT_NEAR(area_of(mesh), 16.0F, 0.2F);
}

TEST(MergedMesh, JsonHasTheBytesInBase64) {
  const MergedMesh mesh = merge_items({box_at(0.0F, {1, 1, 1})});
  const nlohmann::ordered_json json = mesh_json(mesh);
  const auto base64_size = [](std::size_t bytes) { return (bytes + 2) / 3 * 4; };
  EXPECT_EQ(json.at("positions").get<std::string>().size(), base64_size(24 * 12));
  EXPECT_EQ(json.at("normals").get<std::string>().size(), base64_size(24 * 3));
  EXPECT_EQ(json.at("colors").get<std::string>().substr(0, 4), "////");
  EXPECT_EQ(json.at("indices").get<std::string>().size(), base64_size(36 * 4));
  EXPECT_NEAR(static_cast<double>(json_size(mesh)), static_cast<double>(json.dump().size()), 100.0);
}

}  // namespace
}  // namespace castaway::testbed
