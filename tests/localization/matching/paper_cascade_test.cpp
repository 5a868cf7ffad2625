#include "localization/matching/paper_cascade.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

TEST(PaperCascade, FindsAPlaceThatStandsInOneOfItsOrientations) {
  const OccupancyGrid grid = test::office();
  const PaperCascade cascade({}, {0.05}, grid);
  const SE2 truth{3.025, 3.025, std::numbers::pi / 8.0};
  const auto found = cascade.match(test::points_from(grid, truth));
  ASSERT_FALSE(found.empty());
  EXPECT_LT(distance(found[0].T_map_base, truth), 0.15);
  EXPECT_LT(yaw_distance(found[0].T_map_base, truth), 1e-9);
  EXPECT_GT(found[0].score, 0.7);
}

TEST(PaperCascade, ScoresByTheQualityAtTheFinestLevel) {
  const OccupancyGrid grid = test::office();
  const PaperCascade cascade({}, {0.05}, grid);
  const ScanPoints points = test::points_from(grid, {3.025, 3.025, 0.0});
  const auto found = cascade.match(points);
  ASSERT_FALSE(found.empty());
  const double quality = RayLocalModel({0.05}, grid).evaluate(points, found[0].T_map_base).hits /
                         static_cast<double>(points.size());
  EXPECT_DOUBLE_EQ(found[0].score, quality);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i].score, found[i - 1].score);
}

double nearest_multiple(double yaw, double step) { return std::abs(std::remainder(yaw, step)); }

TEST(PaperCascade, LooksEveryQuarterPiWithWideHeadings) {
  const OccupancyGrid grid = test::office();
  const SE2 truth{3.025, 3.025, std::numbers::pi / 8.0};  // between two of the headings
  const ScanPoints points = test::points_from(grid, truth);
  PublishedDefects wide;
  wide.wide_headings = true;
  PaperCascadeConfig config;
  config.threshold = 0.1;
  const auto found = PaperCascade(config, {0.05}, grid, wide).match(points);
  ASSERT_FALSE(found.empty());
  for (const Candidate& c : found) {
    EXPECT_LT(nearest_multiple(c.T_map_base.yaw, std::numbers::pi / 4.0), 1e-9);
  }
  EXPECT_LT(found[0].score, 0.5 * PaperCascade(config, {0.05}, grid).match(points)[0].score);
}

TEST(PaperCascade, StaysAtCellsOfFourWithOneCoarseLevel) {
  const OccupancyGrid grid = test::office();
  const SE2 truth{3.025, 3.025, 0.0};
  PublishedDefects coarse;
  coarse.one_coarse_level = true;
  const auto found = PaperCascade({}, {0.05}, grid, coarse).match(test::points_from(grid, truth));
  ASSERT_FALSE(found.empty());
  for (const Candidate& c : found) {  // centres of cells of 4 x 5 cm: 0.1 m, 0.3 m, ...
    EXPECT_LT(nearest_multiple(c.T_map_base.x - 0.1, 0.2), 1e-9);
    EXPECT_LT(nearest_multiple(c.T_map_base.y - 0.1, 0.2), 1e-9);
  }
  EXPECT_LT(distance(found[0].T_map_base, truth), 0.3);
}

TEST(PaperCascade, MissesWhatLiesBeyondTheOtherAxisWhenTransposed) {
  // 10 x 4 m with its origin at (0, 0): x is searched below 4 m only.
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
  for (const Candidate& c : PaperCascade({}, {0.05}, grid, transposed).match(points)) {
    EXPECT_LT(c.T_map_base.x, 4.0);
  }
  // The same room 6 m up in map: the limit of x, the upper end in y, lies at 10 m.
  grid.frame.T_map_grid = {0.0, 6.0, 0.0};
  const ScanPoints same = test::points_from(grid, {7.525, 8.025, 0.0});
  const auto found = PaperCascade({}, {0.05}, grid, transposed).match(same);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(distance(found[0].T_map_base, {7.525, 8.025, 0.0}), 0.15);
}

TEST(PaperCascade, FindsNothingWithoutBeams) {
  EXPECT_TRUE(PaperCascade({}, {0.05}, test::office()).match({}).empty());
}

}  // namespace
}  // namespace castaway::localization
