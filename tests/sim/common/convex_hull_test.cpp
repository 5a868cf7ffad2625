#include "sim/common/convex_hull.hpp"

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/common/random.hpp"

namespace castaway::sim {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(ConvexHull, LeavesOutPointsInsideAndOnEdges) {
  const Points hull = convex_hull({{1, 1}, {0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 0}});
  EXPECT_EQ(hull, (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(ConvexHull, OfFewerThanThreePointsIsThosePoints) {
  EXPECT_EQ(convex_hull({}), Points{});
  EXPECT_EQ(convex_hull({{3, 1}}), (Points{{3, 1}}));
  EXPECT_EQ(convex_hull({{3, 1}, {1, 2}}), (Points{{3, 1}, {1, 2}}));
}

TEST(ConvexHull, ContainsAllPointsAndTurnsLeftAtEveryCorner) {
  Rng rng(5);
  boost::random::uniform_int_distribution<int> any(-4, 4);
  for (int round = 0; round < 200; ++round) {
    Points points{{-5, -5}, {5, -5}, {0, 5}};
    for (int i = 0; i < 10; ++i) points.emplace_back(any(rng), any(rng));
    const Points hull = convex_hull(points);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Eigen::Vector2d& a = hull[i];
      const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - a;
      EXPECT_GT(cross(edge, hull[(i + 2) % hull.size()] - a), 0.0);
      for (const Eigen::Vector2d& p : points) EXPECT_GE(cross(edge, p - a), 0.0);
    }
  }
}

}  // namespace
}  // namespace castaway::sim
