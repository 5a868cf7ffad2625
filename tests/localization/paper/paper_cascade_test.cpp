#include "localization/paper/paper_cascade.hpp"

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

TEST(PaperCascade, SearchesTheCellsThatPassAndEndsWhereItIsTold) {
  const OccupancyGrid grid = test::office();
  const ScanPoints points = test::points_from(grid, {3.025, 3.025, 0.0});
  PaperCascadeConfig config;
  config.levels = 3;
  config.finest_level = 2;
  const auto left = [](const GridFrame&, int column, int) { return column < 10; };  // x < 2 m
  ASSERT_FALSE(PaperCascade(config, {0.05}, grid).match(points).empty());
  EXPECT_TRUE(PaperCascade(config, {0.05}, grid, left).match(points).empty());
  const auto whole = PaperCascade(config, {0.05}, grid).match(points);
  EXPECT_NEAR(std::remainder(whole[0].T_map_base.x - 0.1, 0.2), 0.0, 1e-9);  // cells of 0.2 m
}

TEST(PaperCascade, FindsNothingWithoutBeams) {
  EXPECT_TRUE(PaperCascade({}, {0.05}, test::office()).match({}).empty());
}

}  // namespace
}  // namespace castaway::localization
