#include "sim/people/forces/cell_list.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "sim/common/random.hpp"

namespace castaway::sim {
namespace {

std::vector<Eigen::Vector2d> scatter(int count, double edge, unsigned seed) {
  Rng rng(seed);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double x = draw_between(0.0, edge, rng);
    points.emplace_back(x, draw_between(-edge, 0.0, rng));
  }
  return points;
}

IndexPairs pairs_by_a_loop(const std::vector<Eigen::Vector2d>& points, double reach) {
  IndexPairs pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if ((points[j] - points[i]).norm() <= reach) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

TEST(CellList, OrdersPointsByRowColumnAndIndex) {
  const CellList cells({{1.5, 0.1}, {0.1, 1.2}, {0.2, 0.3}, {1.1, 0.9}}, 1.0);
  EXPECT_EQ(cells.order(), (std::vector<std::size_t>{2, 0, 3, 1}));
}

TEST(CellList, VisitsEveryPairWithinItsRingsOnce) {
  for (const int rings : {1, 2, 3}) {
    const auto points = scatter(150, 9.0, 4);
    const CellList cells(points, 1.0);
    std::multiset<std::pair<std::size_t, std::size_t>> visited;
    for (std::size_t place = 0; place < points.size(); ++place) {
      cells.visit_later(place, rings, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          visited.insert(std::minmax(cells.order()[place], cells.order()[k]));
        }
      });
    }
    for (const auto& pair : visited) EXPECT_EQ(visited.count(pair), 1U);
    for (const auto& pair : pairs_by_a_loop(points, rings)) EXPECT_EQ(visited.count(pair), 1U);
  }
}

TEST(NearPairs, AreThoseOfALoopInItsOrder) {
  for (const double edge : {0.5, 4.0, 60.0}) {
    const auto points = scatter(120, edge, 7);
    EXPECT_EQ(near_pairs(points, 0.7), pairs_by_a_loop(points, 0.7)) << edge;
  }
}

TEST(NearPairs, OfPointsInARowOrInOnePlace) {
  std::vector<Eigen::Vector2d> row;
  for (int i = 0; i < 9; ++i) row.emplace_back(1000.0 * i, 0.0);
  EXPECT_TRUE(near_pairs(row, 1.0).empty());
  EXPECT_EQ(near_pairs({{2.0, 2.0}, {2.0, 2.0}}, 1.0), (IndexPairs{{0, 1}}));
  EXPECT_TRUE(near_pairs({}, 1.0).empty());
}

}  // namespace
}  // namespace castaway::sim
