#include "localization/amcl.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/grid_drive.hpp"

namespace castaway::localization {
namespace {

const SE2 kStart{1.5, 3.0, 0.0};
const SE2 kForward{0.04, 0.0, 0.02};

PoseWithCovariance known(const SE2& pose) {
  return {pose, Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal()};
}

TEST(Amcl, TracksFromAKnownStart) {
  Amcl localizer({}, test::office(), 1);
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 60; ++i) drive.step(localizer, kForward);
  ASSERT_TRUE(localizer.estimate());
  EXPECT_LT(distance(localizer.estimate()->T_map_base, drive.truth()), 0.25);
  EXPECT_LT(yaw_distance(localizer.estimate()->T_map_base, drive.truth()), 0.15);
}

TEST(Amcl, UpdatesOnTheFirstScanAndThenOnlyAfterMoving) {
  std::chrono::nanoseconds time{};
  Amcl localizer({}, test::office(), 1, [&time] { return time += std::chrono::nanoseconds(1); });
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  const auto updates = [&] { return localizer.diagnostics().cpu_by_stage["correct"].count(); };
  drive.step(localizer, {});
  EXPECT_EQ(updates(), 1);
  for (int i = 0; i < 20; ++i) drive.step(localizer, {});
  EXPECT_EQ(updates(), 1);
  drive.step(localizer,
             {0.2, 0.0, 0.0});  // odom is turned by 1 rad: 0.11 m and 0.17 m along its axes
  EXPECT_EQ(updates(), 1);
  drive.step(localizer, {0.2, 0.0, 0.0});
  EXPECT_EQ(updates(), 2);
  drive.step(localizer, {0.0, 0.0, 0.21});
  EXPECT_EQ(updates(), 3);
}

TEST(Amcl, FollowsOdometryBetweenUpdates) {
  Amcl localizer({}, test::office(), 1);
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  drive.step(localizer, {});
  const SE2 before = localizer.estimate()->T_map_base;
  drive.step(localizer, {0.05, 0.0, 0.1});
  const SE2 after = before * SE2{0.05, 0.0, 0.1};
  EXPECT_NEAR(distance(localizer.estimate()->T_map_base, after), 0.0, 1e-9);
}

TEST(Amcl, AdaptsTheNumberOfParticles) {
  Amcl localizer({}, test::office(), 1);
  EXPECT_EQ(localizer.diagnostics().populations[0].particles.size(), 2000U);
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 40; ++i) drive.step(localizer, kForward);
  EXPECT_LT(localizer.diagnostics().populations[0].particles.size(), 1200U);
  EXPECT_GT(localizer.diagnostics().populations[0].particles.size(), 500U);
}

TEST(Amcl, TracksMoreTightlyWithProductWeights) {
  AmclConfig config;
  config.model = AmclSensorModel::kLikelihoodFieldProb;
  Amcl localizer(config, test::office(), 1);
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 60; ++i) drive.step(localizer, kForward);
  EXPECT_LT(distance(localizer.estimate()->T_map_base, drive.truth()), 0.1);
  EXPECT_LT(localizer.estimate()->covariance(0, 0), 0.01);
}

TEST(Amcl, RepeatsItselfBitForBit) {
  const auto run = [](std::uint64_t seed) {
    Amcl localizer({}, test::office(), seed);
    test::GridDrive drive(test::office(), kStart);
    for (int i = 0; i < 10; ++i) drive.step(localizer, kForward);
    return localizer.estimate()->T_map_base;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST(Amcl, RefusesAMapWithoutFreeCells) {
  OccupancyGrid grid = test::office();
  grid.cells.assign(grid.cells.size(), CellState::kUnknown);
  EXPECT_THROW(Amcl({}, grid, 1), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
