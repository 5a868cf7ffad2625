#include "sim/navigation/movers.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/common/random.hpp"
#include "tests/sim/support/people_scene.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr milliseconds kScan(100);

/// Points of two legs of a person who walks with velocity `v` and a stride of a metre: one leg is
/// planted while the other passes it at twice the speed.
std::vector<SeenPoint> legs(const Eigen::Vector2d& middle, const Eigen::Vector2d& v,
                            nanoseconds stamp) {
  const double t = std::chrono::duration<double>(stamp).count();
  const double reach = 0.25 * std::min(v.norm(), 1.4);
  const Eigen::Vector2d ahead = v.norm() > 0.0 ? Eigen::Vector2d(v.normalized()) : v;
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const Eigen::Vector2d swing = reach * std::cos(2.0 * std::numbers::pi * v.norm() * t) * ahead;
  const Eigen::Vector2d apart =
      v.norm() > 0.0 ? Eigen::Vector2d(0.1 * left) : Eigen::Vector2d(0.0, 0.1);
  return {{middle + swing + apart, stamp}, {middle - swing - apart, stamp}};
}

void add(std::vector<SeenPoint>& points, const std::vector<SeenPoint>& more) {
  points.insert(points.end(), more.begin(), more.end());
}

TEST(Movers, HaveTheVelocityOfWhoWalks) {
  Movers movers;
  const Eigen::Vector2d v(-1.2, 0.3);
  Eigen::Vector2d p(6.0, 0.0);
  nanoseconds stamp{};
  for (int i = 0; i < 20; ++i, stamp += kScan, p += 0.1 * v) movers.update(legs(p, v, stamp));
  const auto seen = movers.extrapolate(stamp);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_LT((seen[0].velocity - v).norm(), 0.15);
  EXPECT_LT((seen[0].p - p).norm(), 0.1);  // Their current position, one scan later.
}

TEST(Movers, KeepUpWithWhoSetsOffQuickly) {
  Movers movers;
  Eigen::Vector2d p(4.0, 0.0);
  nanoseconds stamp{};
  for (int i = 0; i < 10; ++i, stamp += kScan) movers.update(legs(p, {0.0, 0.0}, stamp));
  ASSERT_EQ(movers.extrapolate(stamp).size(), 1U);
  EXPECT_TRUE(movers.extrapolate(stamp)[0].stands());
  Eigen::Vector2d v(0.0, 0.0);
  for (int i = 0; i < 10; ++i, stamp += kScan, p += 0.1 * v) {
    v.x() = std::max(v.x() - 0.3, -1.9);  // 3 m/s^2
    movers.update(legs(p, v, stamp));
  }
  ASSERT_EQ(movers.extrapolate(stamp).size(), 1U);
  EXPECT_LT(movers.extrapolate(stamp)[0].velocity.x(), -1.3);
}

TEST(Movers, AreNotKnownFromAFewScans) {
  Movers movers;
  nanoseconds stamp{};
  for (int i = 0; i < 3; ++i, stamp += kScan) {
    movers.update(legs({2.0 + 0.1 * i, 1.0}, {1.0, 0.0}, stamp));
  }
  EXPECT_TRUE(movers.extrapolate(stamp).empty());
}

TEST(Movers, AreToldApart) {
  Movers movers;
  nanoseconds stamp{};
  for (int i = 0; i < 20; ++i, stamp += kScan) {
    std::vector<SeenPoint> points = legs({6.0 - 0.12 * i, 0.6}, {-1.2, 0.0}, stamp);
    add(points, legs({1.0 + 0.1 * i, -0.6}, {1.0, 0.0}, stamp));
    movers.update(points);
  }
  const auto seen = movers.extrapolate(stamp);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].velocity.x(), -1.2, 0.15);
  EXPECT_NEAR(seen[1].velocity.x(), 1.0, 0.15);
}

/// Two people walking abreast are two movers, however close their legs come.
TEST(Movers, WalkSideBySide) {
  Movers movers;
  nanoseconds stamp{};
  for (int i = 0; i < 30; ++i, stamp += kScan) {
    std::vector<SeenPoint> points = legs({6.0 - 0.1 * i, 0.0}, {-1.0, 0.0}, stamp);
    add(points, legs({6.0 - 0.1 * i, 0.65}, {-1.0, 0.0}, stamp));
    movers.update(points);
  }
  EXPECT_EQ(movers.extrapolate(stamp).size(), 2U);
}

TEST(Movers, AreCarriedOnWhileHiddenAndThenForgotten) {
  Movers movers;
  nanoseconds stamp{};
  for (int i = 0; i < 20; ++i, stamp += kScan) {
    movers.update(legs({6.0 - 0.12 * i, 0.0}, {-1.2, 0.0}, stamp));
  }
  movers.update({});
  movers.update({});
  const auto hidden = movers.extrapolate(stamp + 2 * kScan);
  ASSERT_EQ(hidden.size(), 1U);
  EXPECT_NEAR(hidden[0].p.x(), 6.0 - 0.12 * 22, 0.15);
  EXPECT_TRUE(movers.extrapolate(stamp + milliseconds(700)).empty());
}

/// Beams that hit one leg twice, 40 ms apart, and the other once: each leg counts once, with the
/// mean of its places and stamps.
TEST(Movers, CountALegThatIsHitTwiceOnce) {
  Movers movers;
  const Eigen::Vector2d v(1.2, -0.5);
  const Eigen::Vector2d apart(0.04, 0.1);
  const milliseconds later(40);
  const auto middle_at = [&](nanoseconds stamp) {
    return Eigen::Vector2d(std::chrono::duration<double>(stamp).count() * v);
  };
  nanoseconds stamp{};
  for (int i = 0; i < 40; ++i, stamp += kScan) {
    movers.update({{middle_at(stamp) + apart, stamp},
                   {middle_at(stamp + later) + apart, stamp + later},
                   {middle_at(stamp + later / 2) - apart, stamp + later / 2}});
  }
  const auto seen = movers.extrapolate(stamp);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_LT((seen[0].velocity - v).norm(), 1e-3);
  EXPECT_LT((seen[0].p - middle_at(stamp)).norm(), 1e-3);
}

/// There are never more people than points.
TEST(Movers, AreNeverMoreThanWhatIsSeen) {
  Rng rng(5);
  Movers movers;
  nanoseconds stamp{};
  for (int i = 0; i < 200; ++i, stamp += kScan) {
    std::vector<SeenPoint> points;
    for (int k = 0; k < 40; ++k) {
      points.push_back({{draw_between(0.0, 3.0, rng), draw_between(0.0, 3.0, rng)}, stamp});
    }
    movers.update(points);
    ASSERT_LE(movers.extrapolate(stamp).size(), 400U);
  }
  for (const Mover& mover : movers.extrapolate(stamp)) EXPECT_TRUE(mover.p.allFinite());
}

}  // namespace
}  // namespace castaway::sim
