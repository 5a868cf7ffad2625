#include "localization/paper/published/published_stages.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

double nearest_multiple(double yaw, double step) { return std::abs(std::remainder(yaw, step)); }

TEST(PublishedCascade, LooksEveryQuarterPiWithWideHeadings) {
  const OccupancyGrid grid = test::office();
  const SE2 truth{3.025, 3.025, std::numbers::pi / 8.0};  // between two of the headings
  const ScanPoints points = test::points_from(grid, truth);
  PublishedDefects wide;
  wide.wide_headings = true;
  PaperCascadeConfig config;
  config.threshold = 0.1;
  const auto found = published_cascade(config, {0.05}, grid, wide).match(points);
  ASSERT_FALSE(found.empty());
  for (const Candidate& c : found) {
    EXPECT_LT(nearest_multiple(c.T_map_base.yaw, std::numbers::pi / 4.0), 1e-9);
  }
  EXPECT_LT(found[0].score, 0.5 * PaperCascade(config, {0.05}, grid).match(points)[0].score);
}

TEST(PublishedCascade, StaysAtCellsOfFourWithOneCoarseLevel) {
  const OccupancyGrid grid = test::office();
  const SE2 truth{3.025, 3.025, 0.0};
  PublishedDefects coarse;
  coarse.one_coarse_level = true;
  const auto found =
      published_cascade({}, {0.05}, grid, coarse).match(test::points_from(grid, truth));
  ASSERT_FALSE(found.empty());
  for (const Candidate& c : found) {  // centres of cells of 4 x 5 cm: 0.1 m, 0.3 m, ...
    EXPECT_LT(nearest_multiple(c.T_map_base.x - 0.1, 0.2), 1e-9);
    EXPECT_LT(nearest_multiple(c.T_map_base.y - 0.1, 0.2), 1e-9);
  }
  EXPECT_LT(distance(found[0].T_map_base, truth), 0.3);
}

TEST(PublishedCascade, MissesWhatLiesBeyondTheOtherAxisWhenTransposed) {
  // 10 x 4 m with its origin at (0, 0): x is searched only below 4 m.
  OccupancyGrid grid;
  grid.frame = {200, 80, 0.05, {}};
  grid.cells.assign(grid.frame.size(), CellState::kFree);
  test::fill(grid, 6.0, 0.5, 9.0, 3.5, CellState::kOccupied);
  test::fill(grid, 6.1, 0.6, 8.9, 3.4, CellState::kFree);
  test::fill(grid, 6.1, 0.6, 7.0, 1.0, CellState::kOccupied);
  PublishedDefects transposed;
  transposed.transposed_search = true;
  const ScanPoints points = test::points_from(grid, {7.525, 2.025, 0.0});
  ASSERT_FALSE(PaperCascade({}, {0.05}, grid).match(points).empty());
  for (const Candidate& c : published_cascade({}, {0.05}, grid, transposed).match(points)) {
    EXPECT_LT(c.T_map_base.x, 4.0);
  }
  // The same room 6 m up in map: the limit of x is the upper end in y, 10 m.
  grid.frame.T_map_grid = {0.0, 6.0, 0.0};
  const ScanPoints same = test::points_from(grid, {7.525, 8.025, 0.0});
  const auto found = published_cascade({}, {0.05}, grid, transposed).match(same);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(distance(found[0].T_map_base, {7.525, 8.025, 0.0}), 0.15);
}

TEST(PointsAtBase, ForgetTheMount) {
  LaserScan scan = test::scan_at(test::office(), {3.0, 3.0, 0.0}, Stamp(0), 4);
  scan.T_base_laser.translation() = Eigen::Vector3d(0.5, 0.0, 0.0);
  TransformBuffer T_odom_base;
  T_odom_base.add(Stamp(0), {});
  const ScanTurn turn{};
  const ScanPoints mounted = *project_scan(scan, T_odom_base, Stamp(0), {});
  const ScanPoints points = points_at_base({scan, turn, T_odom_base}, {});
  ASSERT_EQ(points.size(), mounted.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points.x[i], mounted.x[i] - 0.5F, 1e-6F);
    EXPECT_EQ(points.origin_x[i], 0.0F);
  }
}

}  // namespace
}  // namespace castaway::localization
