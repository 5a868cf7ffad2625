#include "localization/matching/search_space.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(SearchSpace, IsTheWholeGridWithoutAWindow) {
  const SearchSpace space = search_space({5, 4, 0.2, {}}, 12, {});
  EXPECT_TRUE(space.contains({0, 0}));
  EXPECT_TRUE(space.contains({4, 3}));
  EXPECT_FALSE(space.contains({5, 3}));
  EXPECT_FALSE(space.contains({-1, 0}));
  EXPECT_EQ(space.yaws.size(), 12U);
}

TEST(SearchSpace, IsCutToItsWindowOnATurnedMap) {
  const double quarter = std::numbers::pi / 2.0;
  const GridFrame frame{50, 40, 0.2, {1.0, 2.0, quarter}};  // x of the grid is y of the map
  const SearchSpace space = search_space(frame, 12, MatchWindow{{0.0, 4.0, quarter}, 0.3, 0.6});
  EXPECT_EQ(space.low, Eigen::Vector2i(8, 3));  // centre: 2.0 m, 1.0 m in the grid
  EXPECT_EQ(space.high, Eigen::Vector2i(11, 6));
  EXPECT_EQ(space.yaws, (std::vector<int>{0, 1, 11}));
}

TEST(TurnedScan, RoundsToCellsAndLeavesOutWhatIsTooFar) {
  ScanPoints points;
  points.x = {1.0F, 0.29F, 9.0F};
  points.y = {0.0F, -0.31F, 0.0F};
  const auto scan = rotate_scan(points, 64, 0.2, std::numbers::pi / 2.0, 20);
  ASSERT_EQ(scan.size(), 2U);
  EXPECT_EQ(scan[0].dx, 0);
  EXPECT_EQ(scan[0].dy, 5);
  EXPECT_EQ(scan[1].dx, 2);  // 0.31 m
  EXPECT_EQ(scan[1].dy, 1);  // 0.29 m
}

TEST(TurnedScan, TakesPointsEvenly) {
  ScanPoints points;
  for (int i = 0; i < 10; ++i) points.x.push_back(0.2F * static_cast<float>(i));
  points.y.assign(10, 0.0F);
  const auto scan = rotate_scan(points, 5, 0.2, 0.0, 20);
  ASSERT_EQ(scan.size(), 5U);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(scan[static_cast<std::size_t>(k)].dx, 2 * k);
}

}  // namespace
}  // namespace castaway::localization
