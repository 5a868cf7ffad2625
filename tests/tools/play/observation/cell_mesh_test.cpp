#include "tools/play/observation/cell_mesh.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

TEST(CellCorners, AreThoseOfTheCellInATurnedGrid) {
  const localization::GridFrame frame{4, 4, 0.5, {10.0, 20.0, std::numbers::pi / 2.0}};
  const auto rise = [](const Eigen::Vector2d& p) { return 1.0 + p.x(); };
  const CellCorners corners = cell_corners(frame, {1, 0}, 0.5, rise);
  // x of the grid is y of map, y of the grid is -x.
  EXPECT_TRUE(corners[0].isApprox(Vector3f(10.0F, 20.5F, 0.75F)));
  EXPECT_TRUE(corners[1].isApprox(Vector3f(10.0F, 21.0F, 1.25F)));
  EXPECT_TRUE(corners[2].isApprox(Vector3f(9.5F, 21.0F, 1.25F)));
  EXPECT_TRUE(corners[3].isApprox(Vector3f(9.5F, 20.5F, 0.75F)));
}

TEST(AddCell, AddsTwoTrianglesThatFaceUp) {
  const localization::GridFrame frame{1, 1, 1.0, {}};
  sim::TriangleMesh mesh;
  for (int i = 0; i < 2; ++i) {
    add_cell(cell_corners(frame, {0, 0}, 1.0, [](const Eigen::Vector2d&) { return 0.0; }),
             Vector3f::UnitZ(), Vector3f::Ones(), mesh);
  }
  ASSERT_EQ(mesh.vertices.size(), 8U);
  ASSERT_EQ(mesh.indices.size(), 12U);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vector3f& a = mesh.vertices[mesh.indices[i]];
    const Vector3f& b = mesh.vertices[mesh.indices[i + 1]];
    const Vector3f& c = mesh.vertices[mesh.indices[i + 2]];
    EXPECT_TRUE((b - a).cross(c - a).isApprox(Vector3f::UnitZ()));
  }
}

}  // namespace
}  // namespace castaway::testbed
