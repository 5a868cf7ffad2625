#include "localization/paper/paper_cascade.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/localization/paper/naive_rays.hpp"
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

/// Expects the candidates of the naive cascade, bit for bit and in the same order; returns their
/// number.
std::size_t expect_naive(const PaperCascadeConfig& config, const OccupancyGrid& grid,
                         const ScanPoints& points) {
  const auto nodes = test::naive_cascade(config, 0.05, grid, points);
  const auto naive = test::distinct(config, nodes);
  const auto found = PaperCascade(config, {0.05}, grid).match(points);
  EXPECT_EQ(found.size(), naive.size());
  for (std::size_t i = 0; i < std::min(found.size(), naive.size()); ++i) {
    EXPECT_EQ(found[i].T_map_base, naive[i].T_map_base);
    EXPECT_EQ(found[i].score, naive[i].score);
  }
  return found.size();
}

TEST(PaperCascade, EqualsTheNaiveCascadeExactly) {
  Rng rng = substream(8, "cascade");
  std::size_t found = 0;
  for (int round = 0; round < 12; ++round) {
    const OccupancyGrid grid = round % 2 == 0 ? test::turned_room(rng) : test::random_room(rng);
    const SE2 truth = FreeSpace(grid).sample(rng);
    PaperCascadeConfig config;
    config.levels = 2 + round % 3;
    config.finest_level = round % 2;
    config.threshold = round % 4 == 0 ? 0.3 : 0.5;
    if (round % 3 == 0) config.max_per_level = 40;
    found += expect_naive(config, grid, test::scan_from(grid, truth, 40 + 10 * round));
  }
  EXPECT_GT(found, 20U);
}

TEST(PaperCascade, FindsNothingWithoutLevels) {
  PaperCascadeConfig config;
  config.finest_level = config.levels;
  const OccupancyGrid grid = test::office();
  EXPECT_TRUE(PaperCascade(config, {0.05}, grid).match(test::points_from(grid, {3, 3, 0})).empty());
}

TEST(PaperCascade, FindsNothingWithoutBeams) {
  EXPECT_TRUE(PaperCascade({}, {0.05}, test::office()).match({}).empty());
}

}  // namespace
}  // namespace castaway::localization
