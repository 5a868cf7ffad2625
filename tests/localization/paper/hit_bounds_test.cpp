#include "localization/paper/hit_bounds.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "localization/paper/rays_at_yaw.hpp"
#include "tests/localization/matching/search_case.hpp"
#include "tests/localization/paper/naive_rays.hpp"
#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

std::vector<std::int64_t> bounds_in_row(const RayLocalModel& model, const ScanPoints& points,
                                        int row) {
  const HitBounds bounds(model);
  const RaysAtYaw rays(model, points, 0.0);
  std::vector<std::int64_t> sums;
  for (int c = 0; c < model.frame().width; ++c) sums.push_back(bounds.at(rays.ends(), {c, row}));
  return sums;
}

TEST(HitBounds, GiveAWallAFullHitAndFarCellsNone) {
  const RayLocalModel model({0.05}, test::string_map({"......#..."}, 0.05));
  const auto sums = bounds_in_row(model, test::forward_beams({0.05F}), 0);
  const auto near = static_cast<std::int64_t>(std::ceil(255.0 * std::exp(-0.5)));
  EXPECT_EQ(sums[5], 255);
  EXPECT_EQ(sums[4], near);
  EXPECT_EQ(sums[6], near);
  EXPECT_EQ(sums[1], 0);  // four cells short
}

/// Expects no bound below the number of hits, and the same bounds one by one and by runs.
void expect_bounds(const RayLocalConfig& sensor, const OccupancyGrid& grid,
                   const ScanPoints& points, double yaw) {
  const RayLocalModel model(sensor, grid);
  const HitBounds bounds(model);
  const auto ends = RaysAtYaw(model, points, yaw).ends();
  for (int row = 0; row < grid.frame.height; ++row) {
    const CellRun run{row, 3, grid.frame.width - 2};
    const auto in_run = bounds.in_run(ends, run);
    for (int column = run.first; column < run.end; ++column) {
      const Eigen::Vector2d p = grid.frame.T_map_grid * grid.frame.centre_of({column, row});
      const double hits = test::naive_ray_score(sensor, grid, points, {p.x(), p.y(), yaw}).hits;
      const double quality = hits / static_cast<double>(points.size());
      const std::int64_t bound = bounds.at(ends, {column, row});
      ASSERT_GE(bound, bounds.least(quality, points.size())) << column << ", " << row;
      ASSERT_EQ(bound, in_run[static_cast<std::size_t>(column - run.first)]);
    }
  }
}

TEST(HitBounds, AreNeverBelowTheHits) {
  Rng rng = substream(17, "hit bounds");
  for (int round = 0; round < 12; ++round) {
    const OccupancyGrid grid = test::turned_room(rng);
    const SE2 truth = FreeSpace(grid).sample(rng);
    const ScanPoints points = test::scan_from(grid, truth, round < 10 ? 60 : 600);
    // Every sixth yaw puts many end points on borders of cells.
    const double turn = round % 6 == 0 ? grid.frame.T_map_grid.yaw : truth.yaw;
    expect_bounds({round % 2 == 0 ? 0.05 : 0.2}, grid, points, turn);
  }
}

TEST(HitBounds, HoldForASensorWorseThanTheCap) {
  Rng rng = substream(18, "hit bounds");
  const OccupancyGrid grid = test::turned_room(rng);
  const SE2 truth = FreeSpace(grid).sample(rng);
  expect_bounds({20.0}, grid, test::scan_from(grid, truth, 20), truth.yaw);  // 600 probes
}

}  // namespace
}  // namespace castaway::localization
