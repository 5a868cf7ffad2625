#include "tools/play/observation/observation.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;
using localization::CellState;

const localization::EndpointConfig kCostModel{0.1, 0.05, 30.0};

/// 5 x 5 cells of 0.1 m with an obstacle in the middle, at (0.25, 0.25), and an unknown corner.
CostMap small_map() {
  localization::OccupancyGrid grid;
  grid.frame = {5, 5, 0.1, {}};
  grid.cells.assign(25, CellState::kFree);
  grid.cells[12] = CellState::kOccupied;
  grid.cells[0] = CellState::kUnknown;
  localization::DistanceField distances(grid, 1.0);
  return {std::move(grid), std::move(distances)};
}

TEST(CostMapItem, HasARectangleForEachCellInTheWindow) {
  const MapWindow all{{0.25, 0.25, 0.0}, 0.0, 1.0};
  const sim::SceneItem item = cost_map_item(small_map(), kCostModel, all);
  ASSERT_EQ(item.mesh.vertices.size(), 4U * 25U);
  EXPECT_EQ(item.mesh.indices.size(), 6U * 25U);
  for (const Vector3f& vertex : item.mesh.vertices) EXPECT_EQ(vertex.z(), 0.0F);
  EXPECT_TRUE(item.mesh.vertices[4 * 12].isApprox(Vector3f(0.2F, 0.2F, 0.0F)));
  EXPECT_TRUE(item.mesh.vertices[4 * 12 + 2].isApprox(Vector3f(0.3F, 0.3F, 0.0F)));
  const MapWindow column{{0.25, 0.25, 0.0}, 0.0, 0.12};  // 3 cells wide, one cell deep.
  EXPECT_EQ(cost_map_item(small_map(), kCostModel, column).mesh.vertices.size(), 4U * 3U);
}

TEST(CostMapItem, IsBluerTheNearerTheObstacle) {
  const MapWindow all{{0.25, 0.25, 0.0}, 0.0, 1.0};
  const sim::SceneItem item = cost_map_item(small_map(), kCostModel, all);
  const auto red_of = [&](std::size_t cell) { return item.mesh.colors[4 * cell].x(); };
  EXPECT_LT(red_of(12), red_of(11));  // The obstacle is the darkest.
  EXPECT_LT(red_of(11), red_of(10));
  EXPECT_FLOAT_EQ(red_of(11), red_of(13));
  const Vector3f unknown = item.mesh.colors[0];
  EXPECT_FLOAT_EQ(unknown.x(), unknown.z());  // Grey.
}

}  // namespace
}  // namespace castaway::testbed
