#include "tools/twin/odometry/odometry_fit.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "sim/sensor/wheel_odometry.hpp"
#include "tests/tools/twin/random_drive.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;
using localization::substream;

constexpr double kFitTrack = 0.36;  // [m]
constexpr double kFitDegree = std::numbers::pi / 180.0;

/// Random errors of a synthetic drive.
struct DriveNoise {
  double drift_along = 0.0;    ///< [m/sqrt(m)]
  double drift_yaw_deg = 0.0;  ///< [deg/sqrt(m)]
  double match_m = 0.0;        ///< [m] Of an aligned pose.
};

constexpr double kWinding = 0.12;  // [rad] Turn by a leg, at most: headings change by 2 rad in 5 m.
constexpr double kGentle = 0.015;

/// Legs of 0.2 m in curves to both sides. The map's motion is odometry's with errors that are
/// applied by hand: a straight line between two half turns.
std::vector<Leg> curvy_legs(int count, double bend, const OdometryErrors& errors,
                            const DriveNoise& noise = {}) {
  constexpr double kWay = 0.2;
  Rng rng = substream(1, "legs");
  boost::random::normal_distribution<double> normal;
  const auto misplaced = [&](const SE2& pose) {
    const double dx = noise.match_m * normal(rng);
    const double dy = noise.match_m * normal(rng);
    return pose * SE2{dx, dy, 0.0};
  };
  std::vector<Leg> legs;
  SE2 T_map_base;
  SE2 T_map_start = misplaced(T_map_base);
  for (int k = 0; k < count; ++k) {
    const double turn = bend * (std::sin(0.11 * k) + 0.15);
    Leg leg;
    leg.steps.push_back({kWay, 0.0, turn, kWay});
    leg.way = kWay;
    const double root = std::sqrt(kWay);
    const double yaw = (1.0 + errors.yaw_scale) * turn + errors.curvature * kWay +
                       noise.drift_yaw_deg * kFitDegree * root * normal(rng);
    const double chord = kWay * (std::abs(yaw) < 1e-9 ? 1.0 : std::sin(0.5 * yaw) / (0.5 * yaw));
    const double along = (1.0 + errors.scale) * chord + noise.drift_along * root * normal(rng);
    T_map_base = T_map_base * SE2{0.0, 0.0, 0.5 * yaw} * SE2{along, 0.0, 0.5 * yaw};
    const SE2 T_map_end = misplaced(T_map_base);
    leg.T_start_end = T_map_start.inverse() * T_map_end;
    T_map_start = T_map_end;
    legs.push_back(leg);
  }
  return legs;
}

/// Legs of 1 m straight on.
std::vector<Leg> straight_legs(int count) {
  Leg leg;
  leg.steps.push_back({1.0, 0.0, 0.0, 1.0});
  leg.T_start_end = {1.0, 0.0, 0.0};
  leg.way = 1.0;
  return std::vector<Leg>(static_cast<std::size_t>(count), leg);
}

/// A drive by a robot whose odometry has these errors, in curves of about `bend` [rad/m], as an
/// exactly aligned log.
AlignedLog simulated_drive(const sim::OdometryConfig& config, int scans, double bend) {
  constexpr int kReadings = 10;  // per scan
  constexpr Stamp kPeriod = std::chrono::milliseconds(20);
  const sim::DriveGeometry geometry{.track = kFitTrack};
  Rng rng = substream(1, "odometry");
  sim::WheelOdometry odometry(config, geometry, rng);
  sim::WheelAngles angles;
  SE2 T_map_base{1.0, -2.0, 0.5};
  AlignedLog log;
  log.T_odom_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  for (int k = 0; k <= scans * kReadings; ++k) {
    const sim::Pose2 T_odom_base = odometry.T_odom_base();
    log.T_odom_base.add(k * kPeriod, {T_odom_base.x, T_odom_base.y, T_odom_base.yaw});
    if (k % kReadings == 0) {
      AlignedScan aligned;
      aligned.scan.stamp = k * kPeriod;
      aligned.T_map_base = T_map_base;
      log.scans.push_back(aligned);
    }
    const double way = 0.02;  // 1 m/s
    const double turn = way * bend * (std::sin(0.01 * k) + 0.15);
    angles.left += (way - 0.5 * kFitTrack * turn) / geometry.radius_left;
    angles.right += (way + 0.5 * kFitTrack * turn) / geometry.radius_right;
    odometry.update(angles, rng);
    T_map_base = T_map_base * SE2{0.0, 0.0, 0.5 * turn} * SE2{way, 0.0, 0.5 * turn};
  }
  return log;
}

TEST(OdometryFit, NeedsTwentyFourStretches) {
  const auto fit = fit_odometry(straight_legs(4 * 24), kFitTrack);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stretches, 24U);
  EXPECT_DOUBLE_EQ(fit->way_m, 96.0);
  EXPECT_FALSE(fit_odometry(straight_legs(4 * 24 - 1), kFitTrack));
  EXPECT_FALSE(fit_odometry({}, kFitTrack));
}

TEST(OdometryFit, OfAPerfectRobotIsZero) {
  const auto fit = fit_odometry(straight_legs(200), kFitTrack);
  ASSERT_TRUE(fit);
  expect_errors(fit->errors.odometry, {}, 1e-9);
  EXPECT_NEAR(fit->radius_error_left.value, 0.0, 1e-9);
  EXPECT_NEAR(fit->radius_error_right.value, 0.0, 1e-9);
  EXPECT_NEAR(fit->track_error.value, 0.0, 1e-9);
  EXPECT_LT(fit->drift_along.value, 1e-5);
  EXPECT_LT(fit->drift_yaw_deg.value, 1e-4);
  EXPECT_LT(fit->match_sigma_m.value, 1e-5);
  EXPECT_EQ(fit->outliers, 0.0);
}

TEST(OdometryFit, OfAPerfectRobotHasItsBaseOnTheDriveAndNoRareErrors) {
  const auto fit = fit_odometry(legs_of({.legs = 2000}), kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->drive_x_m.value, 0.0, 1e-6);
  EXPECT_NEAR(fit->drive_y_m.value, 0.0, 1e-6);
  EXPECT_NEAR(fit->drive_yaw_deg.value, 0.0, 1e-4);
  EXPECT_LT(fit->drift_turn_deg.value, 1e-3);
  EXPECT_LT(fit->stamp_sigma_s.value, 1e-4);
  EXPECT_FALSE(fit->unsigned_distance);
  EXPECT_EQ(fit->slip.slips, 0);
}

TEST(OdometryFit, IsNotSurerOfDistancesThanTheMap) {
  const auto fit = fit_odometry(straight_legs(200), kFitTrack);
  ASSERT_TRUE(fit);
  for (const Figure& figure :
       {fit->scale, fit->radius_error_left, fit->radius_error_right, fit->track_error}) {
    EXPECT_NEAR(figure.interval.high - figure.value, 1.96 * kMapScale, 1e-6);
    EXPECT_NEAR(figure.value - figure.interval.low, 1.96 * kMapScale, 1e-6);
  }
  EXPECT_LT(fit->curvature.interval.high, 1e-6);
}

TEST(OdometryFit, OfARobotThatStandsIsNothing) {
  EXPECT_FALSE(fit_odometry(std::vector<Leg>(1000), kFitTrack));
}

TEST(OdometryFit, OfRecordsWithoutAStretchBetweenTwoBreaksIsNothing) {
  std::vector<Leg> legs = straight_legs(1000);
  for (std::size_t i = 0; i < legs.size(); i += 4) legs[i].breaks = true;  // 3 m in between
  EXPECT_FALSE(fit_odometry(legs, kFitTrack));
}

TEST(OdometryFit, DoesNotUseLegsMuchLongerThanAStretch) {
  std::vector<Leg> legs = straight_legs(24 * 4 + 1);
  ASSERT_TRUE(fit_odometry(legs, kFitTrack));
  for (Leg& leg : legs) leg.way = leg.steps[0].way = 13.0;
  EXPECT_FALSE(fit_odometry(legs, kFitTrack));
}

TEST(OdometryFit, FindsErrorsOfEitherSign) {
  for (const double sign : {1.0, -1.0}) {
    const OdometryErrors truth{0.02 * sign, -0.03 * sign, 0.01 * sign};
    const auto fit = fit_odometry(curvy_legs(1500, kWinding, truth), kFitTrack);
    ASSERT_TRUE(fit);
    expect_errors(fit->errors.odometry, truth, 1e-5);
    EXPECT_EQ(fit->scale.value, fit->errors.odometry.scale);
    EXPECT_EQ(fit->yaw_scale.value, fit->errors.odometry.yaw_scale);
    EXPECT_EQ(fit->curvature.value, fit->errors.odometry.curvature);
  }
}

TEST(OdometryFit, FindsErrorsOfTheDriveForTheTrackAskedFor) {
  const OdometryErrors truth{0.02, -0.03, 0.01};
  const auto fit = fit_odometry(curvy_legs(1500, kWinding, truth), kFitTrack);
  ASSERT_TRUE(fit);
  // The right wheel rolls farther than odometry says: its radius is underestimated.
  EXPECT_NEAR(fit->radius_error_left.value, 1.0 / (1.02 - 0.0018) - 1.0, 1e-5);
  EXPECT_NEAR(fit->radius_error_right.value, 1.0 / (1.02 + 0.0018) - 1.0, 1e-5);
  EXPECT_NEAR(fit->track_error.value, 0.97 / 1.02 - 1.0, 1e-5);
}

TEST(OdometryFit, DoesNotUseLegsThatBreak) {
  const OdometryErrors truth{0.02, -0.03, 0.01};
  std::vector<Leg> legs = curvy_legs(3000, kWinding, truth);
  for (std::size_t i = 0; i < legs.size(); i += 60) {
    legs[i].breaks = true;
    legs[i].T_start_end = {3.0, -2.0, 1.5};  // a kidnap
  }
  const auto fit = fit_odometry(legs, kFitTrack);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->stretches, 2U * 50U);  // two of 4 m in each 11.8 m
  expect_errors(fit->errors.odometry, truth, 1e-5);
  EXPECT_EQ(fit->outliers, 0.0);
}

TEST(OdometryFit, FindsTheErrorsOfSimulatedWheels) {
  for (const double sign : {1.0, -1.0}) {
    sim::OdometryConfig config = sim::ideal_odometry();
    config.radius_error_left = 0.01 * sign;
    config.radius_error_right = -0.02 * sign;
    config.track_error = 0.04 * sign;
    const auto fit =
        fit_odometry(take_legs(simulated_drive(config, 1000, 1.0), kFitTrack), kFitTrack);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->radius_error_left.value, 0.01 * sign, 1e-4);
    EXPECT_NEAR(fit->radius_error_right.value, -0.02 * sign, 1e-4);
    EXPECT_NEAR(fit->track_error.value, 0.04 * sign, 1e-4);
    EXPECT_EQ(fit->outliers, 0.0);
  }
}

TEST(OdometryFit, SeparatesTheRandomWalkFromTheAlignment) {
  const DriveNoise noise{.drift_along = 0.02, .drift_yaw_deg = 1.0, .match_m = 0.012};
  const auto fit = fit_odometry(curvy_legs(6000, kGentle, {}, noise), kFitTrack);
  ASSERT_TRUE(fit);
  const double n = static_cast<double>(fit->stretches);
  const double share = 4.0 / std::sqrt(2.0 * n);  // of a standard deviation by n stretches
  EXPECT_NEAR(fit->drift_yaw_deg.value, noise.drift_yaw_deg, share * noise.drift_yaw_deg);
  EXPECT_NEAR(fit->drift_along.value, noise.drift_along, 2.0 * share * noise.drift_along);
  EXPECT_NEAR(fit->match_sigma_m.value, noise.match_m, 2.0 * share * noise.match_m);
  EXPECT_LT(fit->outliers, 0.01);
  // Errors of the mean along and of the mean turn, of stretches of 4 m.
  const double along = std::sqrt(noise.drift_along * noise.drift_along / 4.0 +
                                 2.0 * noise.match_m * noise.match_m / 16.0);
  EXPECT_NEAR(fit->scale.value, 0.0, 5.0 * along / std::sqrt(n));
  // The path bends by this in the mean, so that only the sum of curvature and scale is well known.
  const double bend = 0.15 * kGentle / 0.2;  // [rad/m]
  EXPECT_NEAR(fit->curvature.value + bend * fit->yaw_scale.value, 0.0,
              5.0 * 1.0 * kFitDegree / std::sqrt(4.0 * n));
  for (const Figure& figure : {fit->drift_along, fit->drift_yaw_deg, fit->match_sigma_m}) {
    EXPECT_LT(figure.interval.low, figure.value);
    EXPECT_GT(figure.interval.high, figure.value);
    EXPECT_LT(figure.interval.high - figure.interval.low, figure.value);
  }
}

// Where the path winds, steps along it are not steps along the final heading.
TEST(OdometryFit, SeparatesTheRandomWalkFromTheAlignmentInCurves) {
  const DriveNoise noise{.drift_along = 0.02};
  const auto fit = fit_odometry(curvy_legs(6000, kWinding, {}, noise), kFitTrack);
  ASSERT_TRUE(fit);
  const double share = 4.0 / std::sqrt(2.0 * static_cast<double>(fit->stretches));
  EXPECT_NEAR(fit->drift_along.value, noise.drift_along, share * noise.drift_along);
  EXPECT_LT(fit->match_sigma_m.value, 0.006);  // the alignment is exact
}

TEST(OdometryFit, FindsTheRandomWalkOfSimulatedWheels) {
  sim::OdometryConfig config = sim::ideal_odometry();
  config.drift_along = 0.015;
  config.drift_yaw_deg = 0.8;
  const auto fit =
      fit_odometry(take_legs(simulated_drive(config, 3000, 0.1), kFitTrack), kFitTrack);
  ASSERT_TRUE(fit);
  const double share = 4.0 / std::sqrt(2.0 * static_cast<double>(fit->stretches));
  EXPECT_NEAR(fit->drift_along.value, config.drift_along, share * config.drift_along);
  EXPECT_NEAR(fit->drift_yaw_deg.value, config.drift_yaw_deg, share * config.drift_yaw_deg);
  EXPECT_LT(fit->match_sigma_m.value, 0.005);  // the alignment is exact
}

TEST(OdometryFit, CountsOutliersAndWithstandsThem) {
  const OdometryErrors truth{0.01, 0.02, -0.01};
  const DriveNoise noise{.drift_along = 0.01, .drift_yaw_deg = 0.5, .match_m = 0.005};
  std::vector<Leg> legs = curvy_legs(5000, kGentle, truth, noise);
  for (std::size_t i = 100; i < legs.size(); i += 500) legs[i].T_start_end.x -= 0.19;  // slips
  const auto fit = fit_odometry(legs, kFitTrack);
  ASSERT_TRUE(fit);
  const double n = static_cast<double>(fit->stretches);
  EXPECT_GE(fit->outliers, 9.5 / n);
  EXPECT_LE(fit->outliers, 12.5 / n);  // ten slips
  EXPECT_NEAR(fit->scale.value, truth.scale, 0.002);
  EXPECT_NEAR(fit->drift_along.value, noise.drift_along, 0.5 * noise.drift_along);
}

TEST(OdometryFit, KnowsOnlySystematicErrorsWithoutIntervals) {
  const DriveErrors truth{errors_of(0.02, -0.03, 0.01, kRandomTrack), {0.12, -0.05, 0.03}};
  const DriveErrors found = fit_drive_errors(legs_of({.errors = truth}), kRandomTrack);
  expect_errors(found.odometry, truth.odometry, 1e-4);
  EXPECT_LT(localization::distance(found.T_base_drive, truth.T_base_drive), 0.002);
  EXPECT_NEAR(found.T_base_drive.yaw, 0.03, 1e-3);
  const DriveErrors none = fit_drive_errors(straight_legs(4 * 24 - 1), kFitTrack);
  EXPECT_EQ(none.odometry.scale, 0.0);
  EXPECT_EQ(none.T_base_drive, SE2{});
}

// Odometry counts a third of the way, which is driven back, as driven ahead.
TEST(OdometryFit, OfUnsignedDistancesHasTheErrorsOfTheDrive) {
  const OdometryErrors truth{0.02, -0.03, 0.0};
  std::vector<Leg> legs;
  for (const Leg& leg : curvy_legs(3000, kWinding, truth)) {
    legs.push_back(leg);
    if (legs.size() / 60 % 3 != 2) continue;
    OdometryStep step = leg.steps[0];
    step.along = -step.along;
    legs.back().T_start_end = correct_motion({step}, truth);
  }
  const auto fit = fit_odometry(legs, kFitTrack);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->unsigned_distance);
  expect_errors(fit->errors.odometry, truth, 2e-4);
  EXPECT_EQ(fit->outliers, 0.0);
}

}  // namespace
}  // namespace castaway::testbed
