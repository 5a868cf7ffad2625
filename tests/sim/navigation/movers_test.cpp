#include "sim/navigation/movers.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

constexpr double kPeriod = 0.05;

/// Two legs about a middle.
std::vector<Eigen::Vector2d> legs(const Eigen::Vector2d& middle) {
  return {middle + Eigen::Vector2d(0.0, 0.1), middle - Eigen::Vector2d(0.0, 0.1)};
}

TEST(Movers, HaveTheVelocityOfWhatMoves) {
  Movers movers(kPeriod);
  Eigen::Vector2d p(4.0, 0.0);
  for (int i = 0; i < 20; ++i) {
    movers.update(legs(p));
    p += kPeriod * Eigen::Vector2d(-1.2, 0.3);
  }
  const auto moving = movers.moving();
  ASSERT_EQ(moving.size(), 1U);
  EXPECT_NEAR(moving[0].velocity.x(), -1.2, 1e-9);
  EXPECT_NEAR(moving[0].velocity.y(), 0.3, 1e-9);
  EXPECT_NEAR((moving[0].p - p).norm(), kPeriod * std::hypot(1.2, 0.3), 1e-9);
}

TEST(Movers, DoNotIncludeWhatStandsOrWasSeenTooShortly) {
  Movers standing(kPeriod);
  for (int i = 0; i < 40; ++i) standing.update(legs({2.0, 1.0}));
  EXPECT_TRUE(standing.moving().empty());
  Movers brief(kPeriod);
  for (int i = 0; i < 8; ++i) brief.update(legs({2.0 + 0.05 * i, 1.0}));
  EXPECT_TRUE(brief.moving().empty());
}

TEST(Movers, AreToldApart) {
  Movers movers(kPeriod);
  for (int i = 0; i < 20; ++i) {
    std::vector<Eigen::Vector2d> points = legs({4.0 - 0.06 * i, 0.6});
    for (const auto& p : legs({1.0 + 0.05 * i, -0.6})) points.push_back(p);
    movers.update(points);
  }
  const auto moving = movers.moving();
  ASSERT_EQ(moving.size(), 2U);
  EXPECT_NEAR(moving[0].velocity.x(), -1.2, 1e-9);
  EXPECT_NEAR(moving[1].velocity.x(), 1.0, 1e-9);
}

TEST(Movers, AreForgottenWhenTheyAreNotSeen) {
  Movers movers(kPeriod);
  for (int i = 0; i < 20; ++i) movers.update(legs({4.0 - 0.06 * i, 0.0}));
  movers.update({});
  EXPECT_TRUE(movers.moving().empty());
}

}  // namespace
}  // namespace castaway::sim
