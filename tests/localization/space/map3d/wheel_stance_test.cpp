#include "localization/space/map3d/wheel_stance.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::localization {
namespace {

using HeightOf = std::function<double(const Eigen::Vector2d&)>;

StandingPlane rest_on(const WheelStance& wheels, const HeightOf& ground) {
  std::vector<double> heights;
  for (const Eigen::Vector2d& p : wheels.contacts()) {
    heights.push_back(ground(p) - ground({0.0, 0.0}));
  }
  return wheels.rest(heights);
}

double height(const StandingPlane& plane, const Eigen::Vector2d& p) {
  return plane.z + plane.along * p.x() + plane.across * p.y();
}

WheelStance four_wheels(const Eigen::Vector3d& p_base_com) {
  return {{{0.15, 0.2}, {0.15, -0.2}, {-0.15, 0.2}, {-0.15, -0.2}}, p_base_com};
}

TEST(WheelStance, OnAPlaneItStandsAsThePlaneLies) {
  const HeightOf slope = [](const auto& p) { return 3.0 + 0.2 * p.x() - 0.1 * p.y(); };
  const WheelStance tricycle({{0.0, 0.1}, {0.0, -0.1}, {-0.1, 0.0}}, {-0.02, 0.0, 0.1});
  for (const WheelStance& wheels :
       {WheelStance(), four_wheels({0.0, 0.0, 0.15}), four_wheels({0.1, 0.05, 0.3}), tricycle}) {
    const StandingPlane plane = rest_on(wheels, slope);
    EXPECT_NEAR(plane.z, 0.0, 1e-12);
    EXPECT_NEAR(plane.along, 0.2, 1e-12);
    EXPECT_NEAR(plane.across, -0.1, 1e-12);
  }
}

TEST(WheelStance, OfFourWheelsTheOneAwayFromTheLoadIsInTheAir) {
  const HeightOf twisted = [](const auto& p) {
    return p.x() * p.y() / 6.0;
  };  // 5 mm at each wheel.
  const StandingPlane forward = rest_on(four_wheels({0.03, 0.0, 0.1}), twisted);
  EXPECT_NEAR(forward.z, 0.005, 1e-12);
  EXPECT_NEAR(forward.along, -0.005 / 0.15, 1e-12);
  EXPECT_NEAR(forward.across, 0.005 / 0.2, 1e-12);
  EXPECT_NEAR(height(forward, {0.15, -0.2}), -0.005, 1e-12);  // It stands on this one.
  EXPECT_NEAR(height(forward, {-0.15, 0.2}), 0.015, 1e-12);   // 2 cm above the ground.
  const StandingPlane backward = rest_on(four_wheels({-0.03, 0.0, 0.1}), twisted);
  EXPECT_NEAR(backward.along, 0.005 / 0.15, 1e-12);
}

TEST(WheelStance, OnASlopeTheLoadIsFartherDown) {
  const auto twisted_slope = [](double rise) {
    return [rise](const Eigen::Vector2d& p) { return rise * p.x() + p.x() * p.y() / 6.0; };
  };
  const WheelStance wheels = four_wheels({0.0, 0.0, 0.2});
  EXPECT_NEAR(rest_on(wheels, twisted_slope(0.2)).along, 0.2 + 0.005 / 0.15, 1e-12);
  EXPECT_NEAR(rest_on(wheels, twisted_slope(-0.2)).along, -0.2 - 0.005 / 0.15, 1e-12);
}

TEST(WheelStance, NoWheelIsInTheGroundAndThreeTouchIt) {
  Rng random = substream(7, "stances");
  boost::random::uniform_real_distribution<double> rough(-0.02, 0.02);
  boost::random::uniform_real_distribution<double> within(-0.05, 0.05);
  for (int round = 0; round < 1000; ++round) {
    const WheelStance wheels(
        {{0.2, 0.2}, {0.2, -0.2}, {0.0, 0.25}, {0.0, -0.25}, {-0.2, 0.2}, {-0.2, -0.2}},
        {within(random), within(random), 0.1});
    std::vector<double> heights;
    for (int i = 0; i < 6; ++i) heights.push_back(rough(random));
    const StandingPlane plane = wheels.rest(heights);
    int touching = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const double gap = height(plane, wheels.contacts()[i]) - heights[i];
      EXPECT_GE(gap, -1e-6);
      touching += gap < 1e-6 ? 1 : 0;
    }
    EXPECT_GE(touching, 3);
  }
}

TEST(WheelStance, ALoadThatNoWheelsCarryRestsOnTheNearest) {
  const HeightOf twisted = [](const auto& p) { return p.x() * p.y() / 6.0; };
  const StandingPlane plane = rest_on(four_wheels({0.3, 0.0, 0.1}), twisted);
  EXPECT_NEAR(plane.along, -0.005 / 0.15, 1e-12);
}

TEST(WheelStance, WheelsOnALineAreAsIfUnknown) {
  const WheelStance wheels({{0.0, 0.1}, {0.0, -0.1}, {0.0, 0.0}}, {0.0, 0.0, 0.1});
  const HeightOf bump = [](const auto& p) { return p.norm() < 0.1 ? 0.02 : 0.1 * p.x(); };
  const StandingPlane plane = rest_on(wheels, bump);
  EXPECT_EQ(wheels.contacts().size(), 4U);
  EXPECT_NEAR(plane.along, 0.1, 1e-12);
  EXPECT_NEAR(rest_on({}, bump).along, 0.1, 1e-12);
}

}  // namespace
}  // namespace castaway::localization
