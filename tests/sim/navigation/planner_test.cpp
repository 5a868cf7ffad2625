#include "sim/navigation/planner.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/common/random.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

const PlannerConfig kShortest{0.4, 0.0};

double length(const std::vector<Eigen::Vector2d>& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

/// Naive oracle: Bellman-Ford over the same moves.
std::vector<double> all_distances(const Grid& grid, CellIndex goal) {
  std::vector<double> d(grid.cells.size(), std::numeric_limits<double>::infinity());
  d[flat_index(grid, goal)] = 0.0;
  const auto is_free = [&](int c, int r) {
    return grid.contains(c, r) && grid.at(c, r) == Cell::kFree;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int r = 0; r < grid.height; ++r) {
      for (int c = 0; c < grid.width; ++c) {
        for (int dir = 0; dir < 9; ++dir) {
          const int x = c + dir % 3 - 1;
          const int y = r + dir / 3 - 1;
          const bool open = is_free(c, r) && is_free(x, y) && is_free(x, r) && is_free(c, y);
          if (!open) continue;
          const double via = d[flat_index(grid, {x, y})] + std::hypot(x - c, y - r);
          if (via + 1e-9 >= d[flat_index(grid, {c, r})]) continue;
          d[flat_index(grid, {c, r})] = via;
          changed = true;
        }
      }
    }
  }
  return d;
}

TEST(Planner, GoesThroughTheDoor) {
  const FreeSpace free(grid_from_art({".......",  //
                                      "...#...",  //
                                      "...#...",  //
                                      "...#...",  //
                                      "...#..."}),
                       0.1);
  const auto path = plan_path(free, {1.5, 0.5}, {5.5, 0.5}, kShortest);
  ASSERT_TRUE(path.has_value());
  // Three cells up and one diagonally, two through the door, and the same down again.
  EXPECT_NEAR(length(*path), 2.0 * (3.0 + std::sqrt(2.0)) + 2.0, 1e-6);
  EXPECT_TRUE(path->front().isApprox(Eigen::Vector2d(1.5, 0.5)));
  EXPECT_TRUE(path->back().isApprox(Eigen::Vector2d(5.5, 0.5)));
}

TEST(Planner, FindsTheShortestPathsOfAnExhaustiveSearch) {
  Rng rng(4);
  boost::random::uniform_int_distribution<int> die(0, 3);
  for (int round = 0; round < 20; ++round) {
    Grid grid = make_grid(24, 17, 1.0, {0.0, 0.0}, Cell::kFree);
    for (Cell& cell : grid.cells) cell = die(rng) == 0 ? Cell::kOccupied : Cell::kFree;
    const FreeSpace free(grid, 0.1);
    const auto goal = free.nearest_free({12.0, 8.0});
    const std::vector<double> expected = all_distances(free.grid(), *goal);
    for (int i = 0; i < 20; ++i) {
      const Pose2 start = *free.sample(rng);
      const auto path = plan_path(free, start.position(), center_of(grid, *goal), kShortest);
      const double d = expected[flat_index(grid, cell_of(grid, start.position()))];
      ASSERT_EQ(path.has_value(), std::isfinite(d));
      if (path) {
        ASSERT_NEAR(length(*path), d, 1e-4);
      }
    }
  }
}

TEST(Planner, KeepsAwayFromWallsWhereThereIsRoom) {
  const FreeSpace free(make_grid(60, 40, 0.05, {0.0, 0.0}, Cell::kFree), 0.2);
  const auto path = plan_path(free, {0.4, 0.3}, {2.6, 0.3});
  double highest = 0.0;
  for (const auto& p : *path) highest = std::max(highest, p.y());
  EXPECT_GT(highest, 0.45);
}

TEST(Planner, EndsAtTheNearestFreePlace) {
  const FreeSpace free(grid_from_art({".....#",  //
                                      ".....#"}),
                       0.1);
  const auto path = plan_path(free, {0.5, 0.5}, {5.9, 0.5}, kShortest);
  EXPECT_TRUE(path->back().isApprox(Eigen::Vector2d(4.5, 0.5)));
}

TEST(Planner, FindsNothingWhereNothingIsFree) {
  const FreeSpace none(grid_from_art({"##", "##"}), 0.1);
  EXPECT_FALSE(plan_path(none, {0.5, 0.5}, {1.5, 1.5}).has_value());
}

}  // namespace
}  // namespace castaway::sim
