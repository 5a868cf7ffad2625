#include "localization/amcl/amcl.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/grid_drive.hpp"

namespace castaway::localization {
namespace {

using test::kForward;
using test::kStart;

PoseWithCovariance known(const SE2& pose) {
  return {pose, Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal()};
}

/// The particles after the newest update, all with the same weight.
ParticleSet population(const Amcl& localizer) {
  ParticleSet particles{localizer.diagnostics().populations[0].particles, {}};
  particles.log_weights.assign(particles.poses.size(), 0.0);
  return particles;
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
             {0.2, 0.0, 0.0});  // odom is rotated by 1 rad: 0.11 m and 0.17 m along its axes
  EXPECT_EQ(updates(), 1);
  drive.step(localizer, {0.2, 0.0, 0.0});
  EXPECT_EQ(updates(), 2);
  drive.step(localizer, {0.0, 0.0, 0.21});
  EXPECT_EQ(updates(), 3);
}

TEST(Amcl, ThresholdsOfUpdatesAreOfEachAxis) {
  std::chrono::nanoseconds time{};
  Amcl localizer({}, test::office(), 1, [&time] { return time += std::chrono::nanoseconds(1); });
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  const auto updates = [&] { return localizer.diagnostics().cpu_by_stage["correct"].count(); };
  drive.step(localizer, {});
  // 0.29 m exceeds 0.25 m, but odom is rotated by 1 rad: 0.29 cos 1 = 0.157 m along x, 0.29 sin 1 =
  // 0.244 m along y.
  drive.step(localizer, {0.29, 0.0, 0.0});
  EXPECT_EQ(updates(), 1);
  // 0.30 m: 0.252 m along y.
  drive.step(localizer, {0.01, 0.0, 0.0});
  EXPECT_EQ(updates(), 2);
}

TEST(Amcl, UpdatesAtRestIfAskedTo) {
  std::chrono::nanoseconds time{};
  AmclConfig config;
  config.update_at_rest = true;
  Amcl localizer(config, test::office(), 1,
                 [&time] { return time += std::chrono::nanoseconds(1); });
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 7; ++i) drive.step(localizer, {});
  EXPECT_EQ(localizer.diagnostics().cpu_by_stage["correct"].count(), 7);
}

TEST(Amcl, StartsWithTheSpreadGiven) {
  Amcl localizer({}, test::office(), 1);
  localizer.initialize(known(kStart));
  const PoseMoments m = moments(population(localizer));
  // With 2000 particles, a variance is accurate to 4 * sqrt(2 / 2000) = 13 %.
  EXPECT_NEAR(m.covariance(0, 0), 0.04, 0.13 * 0.04);
  EXPECT_NEAR(m.covariance(2, 2), 0.01, 0.13 * 0.01);
}

TEST(Amcl, StartsWithNav2sSpreadWhereNoneIsGiven) {
  Amcl localizer({}, test::office(), 1);
  localizer.initialize(PoseWithCovariance{kStart, Eigen::Matrix3d::Zero()});
  const PoseMoments m = moments(population(localizer));
  EXPECT_NEAR(m.covariance(0, 0), 0.25, 0.13 * 0.25);  // 0.5^2
  EXPECT_NEAR(m.covariance(1, 1), 0.25, 0.13 * 0.25);
  EXPECT_NEAR(m.covariance(2, 2), 0.068539, 0.13 * 0.068539);  // (pi / 12)^2
}

TEST(Amcl, StatesTheHeaviestClusterAndTheCovarianceOfTheWholeSet) {
  AmclConfig config;
  config.kld.min_particles = 2000;
  Amcl localizer(config, test::office(), 1);  // spread over the whole map: many clusters
  test::GridDrive drive(test::office(), kStart);
  drive.step(localizer, {});
  const ParticleSet particles = population(localizer);
  const Cluster heaviest = heaviest_cluster({}, particles);
  ASSERT_LT(heaviest.particles.size(), particles.size());
  EXPECT_LT(distance(localizer.estimate()->T_map_base, heaviest.mean), 1e-12);
  EXPECT_EQ(localizer.estimate()->probability, heaviest.weight);
  const Eigen::Matrix3d whole = moments(particles).covariance;
  EXPECT_LT((localizer.estimate()->covariance - whole).norm(), 1e-12);
  EXPECT_GT(whole(0, 0), 1.0);
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

TEST(Amcl, TracksWithTheBeamModel) {
  AmclConfig config;
  config.model = AmclSensorModel::kBeam;
  config.kld.max_particles = 500;
  Amcl localizer(config, test::office(), 1);
  localizer.initialize(known(kStart));
  test::GridDrive drive(test::office(), kStart);
  for (int i = 0; i < 30; ++i) drive.step(localizer, kForward);
  EXPECT_LT(distance(localizer.estimate()->T_map_base, drive.truth()), 0.25);
  EXPECT_LT(yaw_distance(localizer.estimate()->T_map_base, drive.truth()), 0.15);
}

TEST(Amcl, ReadsBeamsWithoutAReturnInTheBeamModelOnly) {
  LaserScan scan;
  scan.stamp = Stamp(10);
  scan.angle_increment = 0.1;
  scan.range_min = 0.1;
  scan.range_max = 3.0;
  scan.ranges.assign(60, std::numeric_limits<float>::infinity());
  const auto says_something = [&](AmclSensorModel model) {
    AmclConfig config;
    config.model = model;
    Amcl localizer(config, test::office(), 1);
    localizer.on_odometry({Stamp(10), {}});
    localizer.on_scan(scan);
    return localizer.estimate().has_value();
  };
  EXPECT_TRUE(says_something(AmclSensorModel::kBeam));
  EXPECT_FALSE(says_something(AmclSensorModel::kLikelihoodField));
}

TEST(Amcl, ShiftsTheMapByHalfACellIfAskedTo) {
  const auto end = [](const AmclConfig& config, const OccupancyGrid& map) {
    Amcl localizer(config, map, 1);
    test::GridDrive drive(test::office(), kStart);
    for (int i = 0; i < 10; ++i) drive.step(localizer, kForward);
    return localizer.estimate()->T_map_base;
  };
  // Cells of 0.05 m: a map with origin (0.025, 0.025) is treated as one with origin (0, 0).
  OccupancyGrid off = test::office();
  off.frame.T_map_grid = {0.025, 0.025, 0.0};
  AmclConfig shifting;
  shifting.half_cell_shift = true;
  EXPECT_EQ(end(shifting, off), end({}, test::office()));
  EXPECT_NE(end({}, off), end({}, test::office()));
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
