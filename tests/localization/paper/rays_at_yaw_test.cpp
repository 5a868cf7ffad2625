#include "localization/paper/rays_at_yaw.hpp"

#include <gtest/gtest.h>

#include "tests/localization/paper/naive_rays.hpp"
#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(RaysAtYaw, CountAPointOnABorderOnBothSides) {
  const RayLocalModel model({0.05}, test::string_map({".........."}, 0.05));
  const auto cells = [&](float range) {
    return RaysAtYaw(model, test::forward_beams({range}), 0.0).ends().size();
  };
  EXPECT_EQ(cells(0.05F), 1U);
  EXPECT_EQ(cells(0.025F), 2U);
  EXPECT_EQ(cells(900.0F), 0U);
}

/// Expects the naive hits at every cell, bit for bit.
void expect_naive_hits(const RayLocalConfig& sensor, const OccupancyGrid& grid,
                       const ScanPoints& points, double yaw) {
  const RayLocalModel model(sensor, grid);
  const RaysAtYaw rays(model, points, yaw);
  for (int row = 0; row < grid.frame.height; ++row) {
    for (int column = 0; column < grid.frame.width; ++column) {
      const Eigen::Vector2d p = grid.frame.T_map_grid * grid.frame.centre_of({column, row});
      const double naive = test::naive_ray_score(sensor, grid, points, {p.x(), p.y(), yaw}).hits;
      ASSERT_EQ(rays.hits({column, row}), naive) << column << ", " << row;
    }
  }
}

TEST(RaysAtYaw, HitAsTheNaiveProbesDo) {
  Rng rng = substream(19, "rays");
  for (int round = 0; round < 12; ++round) {
    const OccupancyGrid grid = round % 3 == 0 ? test::random_room(rng) : test::turned_room(rng);
    const SE2 truth = FreeSpace(grid).sample(rng);
    ScanPoints points = test::scan_from(grid, truth, 60);
    // Every third yaw puts many points on borders of cells.
    const double yaw = round % 3 == 0 ? 0.0 : truth.yaw;
    if (round == 1) points.origin_x = points.x;
    if (round < 2) points.origin_y = points.y;  // in round 1, beams without length
    if (round == 2) points.x[0] = 1e9F;
    expect_naive_hits({round % 2 == 0 ? 0.05 : 0.25}, grid, points, yaw);
  }
}

TEST(RaysAtYaw, HitAsTheNaiveProbesDoForASensorWorseThanTheCap) {
  Rng rng = substream(20, "rays");
  const OccupancyGrid grid = test::turned_room(rng);
  const SE2 truth = FreeSpace(grid).sample(rng);
  expect_naive_hits({20.0}, grid, test::scan_from(grid, truth, 20), truth.yaw);  // 600 probes
}

}  // namespace
}  // namespace castaway::localization
