#include "tools/twin/alignment/odometry_step.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using localization::SE2;

void expect_motion(const SE2& pose, const SE2& expected, double tolerance = 1e-12) {
  EXPECT_NEAR(pose.x, expected.x, tolerance);
  EXPECT_NEAR(pose.y, expected.y, tolerance);
  EXPECT_NEAR(localization::wrap_angle(pose.yaw - expected.yaw), 0.0, tolerance);
}

void expect_step(const OdometryStep& step, const OdometryStep& expected) {
  EXPECT_NEAR(step.along, expected.along, 1e-12);
  EXPECT_NEAR(step.across, expected.across, 1e-12);
  EXPECT_NEAR(step.turn, expected.turn, 1e-12);
  EXPECT_NEAR(step.way, expected.way, 1e-12);
}

TEST(OdometryStep, IsTheTwistOfAMotion) {
  const double quarter = 0.5 * std::numbers::pi;  // of a circle with radius 1
  expect_step(step_of({0.5, 0.2, 0.0}, 0.4), {0.5, 0.2, 0.0, 0.5});
  expect_step(step_of({1.0, 1.0, quarter}, 0.4), {quarter, 0.0, quarter, quarter});
  expect_step(step_of({1.0, -1.0, -quarter}, 0.4), {quarter, 0.0, -quarter, quarter});
  expect_step(step_of({-1.0, 1.0, -quarter}, 0.4), {-quarter, 0.0, -quarter, quarter});
}

TEST(OdometryStep, MeasuresTheTravelOfTheWheels) {
  EXPECT_DOUBLE_EQ(step_of({0.5, 0.0, 0.0}, 0.4).way, 0.5);
  EXPECT_DOUBLE_EQ(step_of({-0.5, 0.0, 0.0}, 0.4).way, 0.5);
  EXPECT_DOUBLE_EQ(step_of({0.0, 0.0, 1.0}, 0.4).way, 0.2);  // half a track for each wheel
  EXPECT_DOUBLE_EQ(step_of({0.0, 0.0, -1.0}, 0.4).way, 0.2);
  EXPECT_NEAR(step_of({0.5, 0.0, 0.01}, 0.4).way, 0.5, 1e-4);  // one more, the other less
  EXPECT_EQ(step_of({}, 0.4).way, 0.0);
}

TEST(CorrectMotion, IsTheOdometryWithoutErrors) {
  expect_motion(correct_motion({}, {0.1, 0.1, 0.1}), {});
  expect_motion(correct_motion({{1.5, 0.25, 0.0, 1.5}}, {}), {1.5, 0.25, 0.0});
  const double quarter = 0.5 * std::numbers::pi;  // of a circle with radius 1
  expect_motion(correct_motion({{quarter, 0.0, quarter, quarter}}, {}), {1.0, 1.0, quarter});
  expect_motion(correct_motion({{quarter, 0.0, -quarter, quarter}}, {}), {1.0, -1.0, -quarter});
  expect_motion(correct_motion({{0.0, quarter, quarter, 0.0}}, {}), {-1.0, 1.0, quarter});
}

TEST(CorrectMotion, LengthensByTheScale) {
  const OdometryErrors errors{.scale = 0.1};
  expect_motion(correct_motion({{1.0, 0.2, 0.0, 1.0}}, errors), {1.1, 0.22, 0.0});
  const double quarter = 0.5 * std::numbers::pi;
  expect_motion(correct_motion({{quarter, 0.0, quarter, quarter}}, errors), {1.1, 1.1, quarter});
}

TEST(CorrectMotion, TurnsMoreByTheYawScale) {
  const OdometryErrors errors{.yaw_scale = 0.1};
  expect_motion(correct_motion({{0.0, 0.0, 1.0, 0.2}}, errors), {0.0, 0.0, 1.1});
  expect_motion(correct_motion({{0.0, 0.0, -1.0, 0.2}}, errors), {0.0, 0.0, -1.1});
  expect_motion(correct_motion({{1.0, 0.0, 0.0, 1.0}}, errors), {1.0, 0.0, 0.0});
}

TEST(CorrectMotion, BendsToTheLeftByThePositiveCurvature) {
  const double quarter = 0.5 * std::numbers::pi;
  const OdometryErrors errors{.curvature = 1.0};
  expect_motion(correct_motion({{quarter, 0.0, 0.0, quarter}}, errors), {1.0, 1.0, quarter});
  expect_motion(correct_motion({{-quarter, 0.0, 0.0, quarter}}, errors), {-1.0, 1.0, -quarter});
  expect_motion(correct_motion({{0.0, 0.0, 1.0, 0.2}}, errors), {0.0, 0.0, 1.0});
}

TEST(CorrectMotion, ChainsSteps) {
  const double quarter = 0.5 * std::numbers::pi;
  expect_motion(
      correct_motion({{1.0, 0.0, 0.0, 1.0}, {0.0, 0.0, quarter, 0.2}, {2.0, 0.0, 0.0, 2.0}}, {}),
      {1.0, 2.0, quarter});
}

TEST(CorrectMotion, InvertsTheStep) {
  for (const double yaw : {-2.0, -0.3, -1e-7, 1e-7, 0.4, 3.0}) {
    const SE2 u{0.3, -0.1, yaw};
    expect_motion(correct_motion({step_of(u, 0.4)}, {}), u);
  }
}

TEST(CorrectMotion, OfASteadyCurveIsThatOfManySmallSteps) {
  const OdometryErrors errors{0.05, -0.03, 0.2};
  const OdometryStep whole{0.8, 0.1, 0.9, 0.8};
  SE2 pose;
  constexpr int kParts = 100000;
  for (int k = 0; k < kParts; ++k) {
    const double turn = ((1.0 - 0.03) * 0.9 + 0.2 * 0.8) / kParts;
    pose = pose * SE2{1.05 * 0.8 / kParts, 1.05 * 0.1 / kParts, turn};
  }
  expect_motion(correct_motion({whole}, errors), pose, 2e-5);
}

TEST(CorrectMotion, AddsDistanceToTurnsByTheSwing) {
  const OdometryErrors errors{.swing = 0.5};
  expect_motion(correct_motion({{1.0, 0.0, 0.0, 1.0}}, errors), {1.0, 0.0, 0.0});
  const double quarter = 0.5 * std::numbers::pi;  // of a circle with radius 0.5
  expect_motion(correct_motion({{0.0, 0.0, quarter, 0.2}}, errors), {0.5, 0.5, quarter});
  expect_motion(correct_motion({{0.0, 0.0, -quarter, 0.2}}, errors), {-0.5, 0.5, -quarter});
}

// True radii 0.048 and 0.051 m and track 0.42 m; odometry believes in 0.05 m and 0.4 m.
TEST(CorrectMotion, IsThatOfADriveWhoseRadiiDiffer) {
  constexpr double kBelieved = 0.4;
  const double left = 0.048 / 0.05;
  const double right = 0.051 / 0.05;
  const OdometryErrors errors =
      errors_of(0.5 * (left + right) - 1.0, kBelieved / 0.42 * 0.5 * (left + right) - 1.0,
                (right - left) / 0.42, 0.42);
  for (const auto& [by_left, by_right] :
       {std::pair{0.3, 0.5}, std::pair{0.5, 0.3}, std::pair{-0.2, 0.2}, std::pair{-0.4, -0.1}}) {
    const double along = 0.5 * (by_left + by_right);
    const double turn = (by_right - by_left) / kBelieved;
    const double true_along = 0.5 * (left * by_left + right * by_right);
    const double true_turn = (right * by_right - left * by_left) / 0.42;
    expect_motion(correct_motion({{along, 0.0, turn, 0.0}}, errors),
                  correct_motion({{true_along, 0.0, true_turn, 0.0}}, {}), 2e-4);
  }
}

TEST(CorrectBaseMotion, IsThatOfTheDriveWhereBaseIsTheDrive) {
  const std::vector<OdometryStep> steps{{0.8, 0.1, 0.9, 0.8}, {0.3, 0.0, -0.2, 0.3}};
  const OdometryErrors errors{0.05, -0.03, 0.2};
  expect_motion(correct_base_motion(steps, {errors, {}}), correct_motion(steps, errors));
}

TEST(CorrectBaseMotion, SwingsBaseAboutTheDrive) {
  const double half = std::numbers::pi;
  const DriveErrors behind{{}, {-0.3, 0.1, 0.0}};  // base is ahead of the drive and on its right
  expect_motion(correct_base_motion({{0.0, 0.0, half, 0.6}}, behind), {-0.6, 0.2, half});
  expect_motion(correct_base_motion({{2.0, 0.0, 0.0, 2.0}}, behind), {2.0, 0.0, 0.0});
}

TEST(CorrectBaseMotion, DrivesWhereTheWheelsRollTo) {
  const double quarter = 0.5 * std::numbers::pi;
  const DriveErrors turned{{.scale = 0.5}, {0.0, 0.0, quarter}};
  expect_motion(correct_base_motion({{2.0, 0.0, 0.0, 2.0}}, turned), {0.0, 3.0, 0.0});
  expect_motion(correct_base_motion({{0.0, 0.0, 0.7, 0.2}}, turned), {0.0, 0.0, 0.7});
}

}  // namespace
}  // namespace castaway::testbed
