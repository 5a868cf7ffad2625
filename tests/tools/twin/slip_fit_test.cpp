#include "tools/twin/odometry/slip_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/twin/random_drive.hpp"

namespace castaway::testbed {
namespace {

constexpr double kSlipLength = 0.2;  // [m] that the wheel rolls
constexpr double kSlipExcess = kSlipLength * SlipFit::kShare / (1.0 - SlipFit::kShare);

/// A drive of about 5000 m without slips.
RandomDrive long_drive() {
  return {.legs = 30000, .along = 0.01, .yaw_by_travel = 0.01, .match = 0.005, .match_yaw = 0.002};
}

SlipFit fit_slips_of(const RandomDrive& drive) {
  const std::vector<Leg> legs = legs_of(drive);
  const std::vector<Stretch> stretches = take_stretches(legs, 1.0);
  const OdometryNoise noise = fit_noise({&stretches}, {}, {}, YawWalk::kTravel);
  return fit_slips(stretches, {}, noise, kRandomTrack, Blocks(legs.size()));
}

/// A stretch straight on whose odometry is ahead and turned.
Stretch missed_stretch(std::size_t leg, double ahead, double yaw) {
  Stretch stretch;
  stretch.steps.push_back({1.0 + ahead, 0.0, yaw, 1.0});
  stretch.T_start_end = {1.0, 0.0, 0.0};
  stretch.way = 1.0;
  stretch.leg = leg;
  return stretch;
}

TEST(SlipFit, CountsStretchesThatAreTurnedAndAhead) {
  const OdometryNoise noise{.yaw_per_m = 1e-4, .yaw_per_rad = 0.0, .match_yaw = 0.0, .stamp = 0.0};
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < 1200; ++k) stretches.push_back(missed_stretch(k, 0.0, 0.0));
  for (const std::size_t k : {50U, 250U, 450U, 650U, 850U, 1150U}) {
    const double side = k % 4 == 2 ? 1.0 : -1.0;
    stretches[k] = missed_stretch(k, 0.03, 0.15 * side);  // an excess of 0.06 m
  }
  stretches[350] = missed_stretch(350, 0.02, 0.035);  // within 4 sigma
  const Blocks blocks(stretches.size());
  const SlipFit fit = fit_slips(stretches, {}, noise, 0.4, blocks);
  EXPECT_EQ(fit.slips, 6);
  EXPECT_DOUBLE_EQ(fit.rate_per_m.value, 6.0 / 2400.0);
  EXPECT_NEAR(fit.length_m, 0.06 * 0.7 / 0.3, 1e-9);
  EXPECT_LT(fit.rate_per_m.interval.low, fit.rate_per_m.value);
  EXPECT_GT(fit.rate_per_m.interval.high, fit.rate_per_m.value);
  stretches[750] = missed_stretch(750, -0.03, 0.15);  // odometry is behind: no slip
  const SlipFit fewer = fit_slips(stretches, {}, noise, 0.4, blocks);
  EXPECT_EQ(fewer.slips, 5);
  EXPECT_DOUBLE_EQ(fewer.rate_per_m.value, 5.0 / 2400.0);
}

TEST(SlipFit, HasTheTailOfTheYawBesideThatOfNoiseAndSlips) {
  const OdometryNoise noise{.yaw_per_m = 1e-4, .yaw_per_rad = 0.0, .match_yaw = 0.0, .stamp = 0.0};
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < 990; ++k) stretches.push_back(missed_stretch(k, 0.0, 0.0));
  for (std::size_t k = 990; k < 1000; ++k) stretches.push_back(missed_stretch(k, 0.03, 0.085));
  const SlipFit fit = fit_slips(stretches, {}, noise, 0.4, Blocks(1000));
  ASSERT_EQ(fit.tail.size(), 24U);
  EXPECT_EQ(fit.tail[6].sigmas, 3.0);  // sigma: 0.01 rad
  EXPECT_NEAR(fit.tail[6].measured, 0.01, 1e-12);
  EXPECT_NEAR(fit.tail[16].measured, 0.01, 1e-12);
  EXPECT_EQ(fit.tail[18].measured, 0.0);
  EXPECT_NEAR(fit.tail[2].model, 0.3173 * 0.99 + 0.01, 1e-4);  // beyond one sigma
  EXPECT_NEAR(fit.tail[12].model, 0.01 * 0.994, 1e-4);         // 2.5 sigma less than a slip turns
  EXPECT_NEAR(fit.tail[17].model, 0.5 * 0.01, 1e-4);           // as much as a slip turns
}

TEST(SlipFit, WithoutClearOnesKnowsAHighestRate) {
  const OdometryNoise noise{.yaw_per_m = 1e-4};
  std::vector<Stretch> stretches;
  for (std::size_t k = 0; k < 1200; ++k) stretches.push_back(missed_stretch(k, 0.0, 0.0));
  const SlipFit fit = fit_slips(stretches, {}, noise, 0.4, Blocks(1200));
  EXPECT_EQ(fit.slips, 0);
  EXPECT_EQ(fit.rate_per_m.value, 0.0);
  EXPECT_EQ(fit.rate_per_m.interval.low, 0.0);
  EXPECT_DOUBLE_EQ(fit.rate_per_m.interval.high, 3.0 / 2400.0);
  EXPECT_EQ(fit.length_m, 0.0);
}

TEST(SlipFit, FindsTheSlipsOfADrive) {
  RandomDrive drive = long_drive();
  drive.slips_per_m = 0.01;
  drive.slip_excess_m = kSlipExcess;
  const SlipFit fit = fit_slips_of(drive);
  const double sigma = 1.0 / std::sqrt(static_cast<double>(fit.slips));  // relative, of a count
  EXPECT_NEAR(fit.rate_per_m.value, 0.01, 0.01 * 4.0 * sigma);
  EXPECT_GT(fit.rate_per_m.interval.low, 0.0);
  EXPECT_NEAR(fit.length_m, kSlipLength, 0.2 * kSlipLength);
}

TEST(SlipFit, OfADriveWithoutSlipsIsNone) {
  for (const int number : {1, 2, 3}) {
    RandomDrive drive = long_drive();
    drive.number = number;
    const SlipFit fit = fit_slips_of(drive);
    EXPECT_LE(fit.rate_per_m.value, 3e-4);
    EXPECT_EQ(fit.rate_per_m.interval.low, 0.0);
  }
}

}  // namespace
}  // namespace castaway::testbed
