// Fits to random drives, whose errors are known.
#include <numbers>
#include <utility>

#include "tests/tools/twin/random_drive.hpp"
#include "tools/twin/odometry/odometry_fit.hpp"

namespace castaway::testbed {
namespace {

constexpr double kDriveDegree = std::numbers::pi / 180.0;

TEST(OdometryFit, FindsThePoseOfTheDrive) {
  for (const SE2& T_base_drive : {SE2{0.12, -0.05, 2.0 * kDriveDegree},
                                  SE2{-0.3, 0.1, -5.0 * kDriveDegree}, SE2{0.0, 0.04, 0.0}}) {
    const DriveErrors truth{errors_of(0.02, -0.03, 0.01, kRandomTrack), T_base_drive};
    const auto fit = fit_odometry(legs_of({.legs = 3000, .errors = truth}), kRandomTrack);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->drive_x_m.value, T_base_drive.x, 0.002);
    EXPECT_NEAR(fit->drive_y_m.value, T_base_drive.y, 0.002);
    EXPECT_NEAR(fit->drive_yaw_deg.value, T_base_drive.yaw / kDriveDegree, 0.1);
    EXPECT_EQ(fit->drive_x_m.value, fit->errors.T_base_drive.x);
    EXPECT_EQ(fit->drive_y_m.value, fit->errors.T_base_drive.y);
    EXPECT_DOUBLE_EQ(fit->drive_yaw_deg.value, fit->errors.T_base_drive.yaw / kDriveDegree);
    expect_errors(fit->errors.odometry, truth.odometry, 1e-4);
    EXPECT_NEAR(fit->errors.odometry.swing, truth.odometry.swing, 1e-5);
  }
}

TEST(OdometryFit, FindsThePoseOfTheDriveDespiteNoise) {
  const SE2 T_base_drive{0.15, -0.06, 3.0 * kDriveDegree};
  const auto fit = fit_odometry(legs_of({.legs = 5000,
                                         .errors = {{}, T_base_drive},
                                         .along = 0.01,
                                         .yaw_by_travel = 0.01,
                                         .match = 0.01,
                                         .match_yaw = 0.005}),
                                kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->drive_x_m.value, T_base_drive.x, 0.01);
  EXPECT_NEAR(fit->drive_y_m.value, T_base_drive.y, 0.01);
  EXPECT_NEAR(fit->drive_yaw_deg.value, 3.0, 0.2);
  for (const auto& [figure, truth] :
       {std::pair{fit->drive_x_m, T_base_drive.x}, std::pair{fit->drive_y_m, T_base_drive.y},
        std::pair{fit->drive_yaw_deg, 3.0}}) {
    const double half = figure.interval.high - figure.value;
    EXPECT_GT(half, 0.0);
    EXPECT_NEAR(figure.value, truth, 2.0 * half);
  }
}

TEST(OdometryFit, FindsAWalkOfTheYawByTurn) {
  const RandomDrive drive{
      .legs = 7000, .along = 0.01, .yaw_by_turn = 0.02, .match = 0.005, .match_yaw = 0.003};
  const auto fit = fit_odometry(legs_of(drive), kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->drift_turn_deg.value * kDriveDegree, 0.02, 0.15 * 0.02);
  EXPECT_LE(fit->drift_turn_deg.interval.low * kDriveDegree, 0.02);
  EXPECT_GE(fit->drift_turn_deg.interval.high * kDriveDegree, 0.02);
  EXPECT_EQ(fit->drift_yaw_deg.value, 0.0);
}

TEST(OdometryFit, FindsAWalkOfTheYawByTravel) {
  const RandomDrive drive{
      .legs = 7000, .along = 0.01, .yaw_by_travel = 0.015, .match = 0.005, .match_yaw = 0.003};
  const auto fit = fit_odometry(legs_of(drive), kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->drift_yaw_deg.value * kDriveDegree, 0.015, 0.15 * 0.015);
  EXPECT_EQ(fit->drift_turn_deg.value, 0.0);
}

TEST(OdometryFit, FindsErrorsOfStamps) {
  const RandomDrive drive{
      .legs = 7000, .along = 0.01, .yaw_by_travel = 0.008, .match = 0.005, .stamp = 0.03};
  const auto fit = fit_odometry(legs_of(drive), kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->stamp_sigma_s.value, 0.03, 0.2 * 0.03);
  EXPECT_LE(fit->stamp_sigma_s.interval.low, 0.03);
  EXPECT_GE(fit->stamp_sigma_s.interval.high, 0.03);
  EXPECT_NEAR(fit->match_sigma_m.value, 0.005, 0.4 * 0.005);
}

TEST(OdometryFit, DoesNotTakeErrorsOfTheAlignmentForErrorsOfStamps) {
  const RandomDrive drive{.legs = 7000, .along = 0.01, .match = 0.015, .match_yaw = 0.005};
  const auto fit = fit_odometry(legs_of(drive), kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->stamp_sigma_s.value, 0.005);
  EXPECT_NEAR(fit->match_sigma_m.value, 0.015, 0.1 * 0.015);
}

TEST(OdometryFit, FindsSlips) {
  RandomDrive drive{.legs = 10000, .along = 0.01, .yaw_by_travel = 0.008, .match = 0.005};
  drive.slips_per_m = 0.01;
  drive.slip_excess_m = 0.06;
  const auto fit = fit_odometry(legs_of(drive), kRandomTrack);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slip.rate_per_m.value, 0.01, 0.4 * 0.01);  // of about 25
  EXPECT_GT(fit->slip.rate_per_m.interval.low, 0.0);
  EXPECT_NEAR(fit->slip.length_m, 0.06 * 0.7 / 0.3, 0.03);
  EXPECT_NEAR(fit->scale.value, 0.0, 0.002);
  drive.slips_per_m = 0.0;
  drive.legs = 5000;
  const auto without_slips = fit_odometry(legs_of(drive), kRandomTrack);
  ASSERT_TRUE(without_slips);
  EXPECT_EQ(without_slips->slip.rate_per_m.interval.low, 0.0);
  EXPECT_LT(without_slips->slip.rate_per_m.value, 5e-4);
}

}  // namespace
}  // namespace castaway::testbed
