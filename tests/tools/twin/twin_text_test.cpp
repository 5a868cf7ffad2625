#include "tools/twin/twin_text.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/twin/twin_logs.hpp"
#include "tools/scenario/world/difference_yaml.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

/// Every beam of the twin's lidar points as in the log, within its plane.
void expect_beams(const sim::LidarConfig& lidar, const LaserScan& scan) {
  ASSERT_EQ(static_cast<std::size_t>(lidar.beams), scan.ranges.size());
  EXPECT_NEAR(lidar.angle_min, scan.angle_min, 1e-5);
  EXPECT_NEAR(lidar.angle_increment, scan.angle_increment, 1e-5 / lidar.beams);
}

sim::DifferenceSpec read_twin_differences(const FittedLog& fitted) {
  std::string text = "differences:";
  for (const char c : "\n" + differences_text(fitted)) {
    text += c == '\n' ? "\n  " : std::string(1, c);
  }
  YamlDocument document = YamlDocument::parse(text, "differences.yaml");
  YamlReader root = document.root();
  return read_differences(root, ".");
}

TEST(TwinText, FollowsTheLogInItsBuildingWithItsMap) {
  const Scenario scenario = read_twin(standing_twin());
  EXPECT_EQ(scenario.name, "twin");
  EXPECT_EQ(scenario.world.file, "world.yaml");
  EXPECT_EQ(scenario.world.map, "map.yaml");
  EXPECT_EQ(scenario.drive.path, "path.tum");
  ASSERT_EQ(scenario.lidars.size(), 1U);
  EXPECT_EQ(scenario.lidars.front().scan_times, "scan_times.txt");
  EXPECT_EQ(scenario.robot.file, kTwinRobot);
  EXPECT_DOUBLE_EQ(scenario.duration_s, 10.5);  // the last scan begins at 10 s
  EXPECT_EQ(names_of(scenario.localizers), (std::vector<std::string>{"mh_amcl", "amcl"}));
}

TEST(TwinText, WithoutModelsIsIdeal) {
  const FittedLog fitted = standing_twin();
  const Scenario scenario = read_twin(fitted);
  const sim::OdometryConfig ideal = sim::ideal_odometry();
  EXPECT_EQ(scenario.odometry.radius_sigma, 0.0);
  EXPECT_EQ(scenario.odometry.track_sigma, 0.0);
  EXPECT_EQ(scenario.odometry.drift_along, 0.0);
  EXPECT_EQ(scenario.odometry.drift_yaw_deg, 0.0);
  EXPECT_EQ(scenario.odometry.drift_turn_deg, 0.0);
  EXPECT_EQ(scenario.odometry.slip.rate, 0.0);
  EXPECT_FALSE(scenario.odometry.unsigned_distance);
  EXPECT_EQ(scenario.odometry.ticks_per_turn, ideal.ticks_per_turn);
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_EQ(lidar.noise.sigma, 0.0);
  EXPECT_EQ(lidar.light.dropout, 0.0);
  EXPECT_EQ(lidar.stamp_sigma, 0.0);
  EXPECT_EQ(lidar.light.dust_rate, 0.0);
  EXPECT_EQ(lidar.noise.beam_bias_sigma, 0.0);
  EXPECT_TRUE(scenario.events.simulated.faults.empty());
  EXPECT_TRUE(scenario.events.simulated.kidnaps.empty());
  EXPECT_EQ(scenario.people.config.walking, 0);
  EXPECT_EQ(differences_text(fitted), "");
}

TEST(TwinText, ReadsBackTheLidar) {
  const FittedLog fitted = standing_twin();
  const LaserScan& scan = fitted.log.scans.front().scan;
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  expect_beams(lidar, scan);
  EXPECT_DOUBLE_EQ(lidar.range_min, 0.15);
  EXPECT_DOUBLE_EQ(lidar.range_max, 25.0);
  EXPECT_DOUBLE_EQ(lidar.rate_hz, 10.0);
  EXPECT_FALSE(lidar.sweep);
  EXPECT_TRUE(lidar.T_base_laser.isApprox(scan.T_base_laser, 1e-6));
}

TEST(TwinText, ASweepingLidarSweeps) {
  FittedLog fitted = standing_twin();
  fitted.log.scans.front().scan.time_increment = std::chrono::microseconds(100);
  EXPECT_TRUE(read_twin_lidar(fitted).sweep);
}

TEST(TwinText, PutsALidarWithoutAHeightAboveTheFloor) {
  FittedLog fitted = standing_twin();
  fitted.log.scans.front().scan.T_base_laser.translation().z() = 0.0;
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).T_base_laser.translation().z(), 0.3);
}

TEST(TwinText, TurnsAClockwiseLidarRound) {
  FittedLog fitted = standing_twin();
  LaserScan& scan = fitted.log.scans.front().scan;
  scan.angle_min = 120.0 * kTwinDegree;
  scan.angle_increment = -0.5 * kTwinDegree;  // down to 30 degrees
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_NEAR(lidar.angle_min, 30.0 * kTwinDegree, 1e-5);
  EXPECT_NEAR(lidar.angle_increment, 0.5 * kTwinDegree, 1e-7);
}

TEST(TwinText, ReadsBackAFullCircle) {
  FittedLog fitted = standing_twin();
  LaserScan& scan = fitted.log.scans.front().scan;
  scan.angle_min = 0.0;
  scan.angle_increment = 2.0 * std::numbers::pi / 360;
  scan.ranges.assign(360, 2.0F);
  expect_beams(read_twin_lidar(fitted), scan);
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = 2.0 * std::numbers::pi / 1440;
  scan.ranges.assign(1440, 2.0F);
  expect_beams(read_twin_lidar(fitted), scan);
}

// As the driver of the RPLIDAR states it: angle_max - angle_min is the full circle.
TEST(TwinText, ReadsBackAFullCircleWhoseLastBeamRepeatsTheFirst) {
  FittedLog fitted = standing_twin();
  LaserScan& scan = fitted.log.scans.front().scan;
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = 2.0 * std::numbers::pi / 360;
  scan.ranges.assign(361, 2.0F);
  expect_beams(read_twin_lidar(fitted), scan);
}

TEST(TwinText, ALidarUpsideDownSeesTheSameSector) {
  FittedLog fitted = standing_twin();
  LaserScan& scan = fitted.log.scans.front().scan;
  scan.angle_min = 30.0 * kTwinDegree;
  scan.angle_increment = 0.5 * kTwinDegree;
  scan.T_base_laser.linear() =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).matrix();
  const auto angle_in_base = [](const Eigen::Isometry3d& T_base_laser, double angle) {
    const Eigen::Vector3d d =
        T_base_laser.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    return std::atan2(d.y(), d.x()) / kTwinDegree;
  };
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  const double first = angle_in_base(lidar.T_base_laser, lidar.angle_min);
  const double last =
      angle_in_base(lidar.T_base_laser, lidar.angle_min + 180.0 * lidar.angle_increment);
  EXPECT_NEAR(std::min(first, last), -120.0, 1e-3);
  EXPECT_NEAR(std::max(first, last), -30.0, 1e-3);
}

TEST(TwinText, ReadsBackNoiseAndDropout) {
  FittedLog fitted = standing_twin();
  RangeNoiseFit noise;
  noise.sigma_m = figure_of(0.0123);
  noise.sigma_relative = figure_of(0.0045);
  noise.bias_m = figure_of(0.037);  // behind the walls of the map
  fitted.fit.world_bias_m = -0.021;
  noise.resolution_m = 0.01;
  fitted.fit.noise = noise;
  LossFit loss;
  loss.dropout = figure_of(0.017);
  loss.dropout_far = figure_of(0.21);
  loss.dropout_grazing = figure_of(0.13);
  fitted.fit.loss = loss;
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_DOUBLE_EQ(lidar.noise.sigma, 0.0123);
  EXPECT_DOUBLE_EQ(lidar.noise.sigma_relative, 0.0045);
  EXPECT_DOUBLE_EQ(lidar.noise.bias, -0.021);
  EXPECT_DOUBLE_EQ(lidar.noise.resolution, 0.01);
  EXPECT_DOUBLE_EQ(lidar.light.dropout, 0.017);
  EXPECT_DOUBLE_EQ(lidar.light.dropout_far, 0.21);
  EXPECT_DOUBLE_EQ(lidar.light.dropout_grazing, 0.13);
}

TEST(TwinText, ReadsBackMixedPixels) {
  FittedLog fitted = standing_twin();
  EXPECT_EQ(read_twin_lidar(fitted).light.divergence_deg, 0.0);
  MixedFit mixed;
  mixed.divergence_deg = figure_of(0.25);
  mixed.reach_m = 0.6;
  fitted.fit.mixed = mixed;
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_DOUBLE_EQ(lidar.light.divergence_deg, 0.25);
  EXPECT_DOUBLE_EQ(lidar.light.mixed_reach, 0.6);
}

TEST(TwinText, ReadsBackTheErrorsOfOdometry) {
  FittedLog fitted = standing_twin();
  OdometryFit odometry;
  odometry.radius_error_left = figure_of(-0.0123);
  odometry.radius_error_right = figure_of(0.0234);
  odometry.track_error = figure_of(0.0345);
  odometry.drift_along = figure_of(0.0456);
  odometry.drift_yaw_deg = figure_of(1.25);
  odometry.drift_turn_deg = figure_of(0.75);
  fitted.fit.odometry = odometry;
  const sim::OdometryConfig read = read_twin(fitted).odometry;
  EXPECT_DOUBLE_EQ(read.radius_error_left, -0.0123);
  EXPECT_DOUBLE_EQ(read.radius_error_right, 0.0234);
  EXPECT_DOUBLE_EQ(read.track_error, 0.0345);
  EXPECT_DOUBLE_EQ(read.drift_along, 0.0456);
  EXPECT_DOUBLE_EQ(read.drift_yaw_deg, 1.25);
  EXPECT_DOUBLE_EQ(read.drift_turn_deg, 0.75);
  EXPECT_EQ(read.slip.rate, 0.0);
  EXPECT_FALSE(read.unsigned_distance);
  EXPECT_EQ(read.radius_sigma, 0.0);
  EXPECT_NO_THROW(sim::validate(read));
}

TEST(TwinText, WhatCannotBeNegativeIsZero) {
  FittedLog fitted = standing_twin();
  RangeNoiseFit noise;
  noise.sigma_m = noise.sigma_relative = figure_of(-0.001);
  fitted.fit.noise = noise;
  LossFit loss;
  loss.dropout = loss.dropout_far = loss.dropout_grazing = figure_of(-0.001);
  fitted.fit.loss = loss;
  fitted.fit.mixed.emplace().divergence_deg = figure_of(-0.001);
  OdometryFit odometry;
  odometry.drift_along = odometry.drift_yaw_deg = odometry.drift_turn_deg = figure_of(-0.001);
  fitted.fit.odometry = odometry;
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_EQ(lidar.noise.sigma, 0.0);
  EXPECT_EQ(lidar.noise.sigma_relative, 0.0);
  EXPECT_EQ(lidar.light.dropout, 0.0);
  EXPECT_EQ(lidar.light.dropout_far, 0.0);
  EXPECT_EQ(lidar.light.dropout_grazing, 0.0);
  EXPECT_EQ(lidar.light.divergence_deg, 0.0);
  EXPECT_EQ(read_twin(fitted).odometry.drift_along, 0.0);
  EXPECT_EQ(read_twin(fitted).odometry.drift_yaw_deg, 0.0);
  EXPECT_EQ(read_twin(fitted).odometry.drift_turn_deg, 0.0);
}

TEST(TwinText, ReadsBackSlips) {
  FittedLog fitted = standing_twin();
  OdometryFit& odometry = fitted.fit.odometry.emplace();
  odometry.slip.rate_per_m = figure_of(0.0123);
  odometry.slip.length_m = 0.27;
  const sim::OdometryConfig read = read_twin(fitted).odometry;
  EXPECT_DOUBLE_EQ(read.slip.rate, 0.0123);
  EXPECT_DOUBLE_EQ(read.slip.length, 0.27);
  EXPECT_DOUBLE_EQ(read.slip.share, SlipFit::kShare);
  EXPECT_FALSE(read.slip.zones);
  EXPECT_NO_THROW(sim::validate(read));
}

TEST(TwinText, ReadsBackThatOdometryCountsReversingAsDrivingAhead) {
  FittedLog fitted = standing_twin();
  fitted.fit.odometry.emplace().unsigned_distance = true;
  EXPECT_TRUE(read_twin(fitted).odometry.unsigned_distance);
}

TEST(TwinText, ReadsBackTheErrorOfStamps) {
  FittedLog fitted = standing_twin();
  fitted.fit.odometry.emplace().stamp_sigma_s = figure_of(0.0234);
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).stamp_sigma, 0.0234);
  fitted.fit.odometry->stamp_sigma_s = figure_of(12.0);
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).stamp_sigma, 10.0);  // the most that a lidar takes
}

TEST(TwinText, ReadsBackDustThatIsThereForSure) {
  FittedLog fitted = standing_twin();
  DustFit& dust = fitted.fit.dust.emplace();
  dust.per_m = figure_of(0.004);
  dust.range_m = 5.5;
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).light.dust_rate, 0.004);
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).light.dust_range, 5.5);
  dust.per_m = figure_of(0.004, 0.005);  // its interval has 0
  EXPECT_EQ(read_twin_lidar(fitted).light.dust_rate, 0.0);
}

TEST(TwinText, ReadsBackOffsetsOfBeamsThatAreThereForSure) {
  FittedLog fitted = standing_twin();
  BeamBiasFit& bias = fitted.fit.beam_bias.emplace();
  bias.sigma_m = figure_of(0.006);
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).noise.beam_bias_sigma, 0.006);
  bias.sigma_m = figure_of(0.006, 0.007);
  EXPECT_EQ(read_twin_lidar(fitted).noise.beam_bias_sigma, 0.0);
}

TEST(TwinText, SeesAsFarAsTheLogDoes) {
  FittedLog fitted = standing_twin();
  fitted.fit.range_limit.emplace().limit_m = figure_of(17.5);
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).range_max, 17.5);
  fitted.fit.range_limit.reset();
  EXPECT_DOUBLE_EQ(read_twin_lidar(fitted).range_max, 25.0);
}

TEST(TwinText, ReadsBackPeople) {
  EXPECT_EQ(read_twin(standing_twin(), 7).people.config.walking, 7);
  EXPECT_EQ(people_text(7), "count: 7\n");
}

TEST(TwinText, TheClockIsWrongForTheWholeRun) {
  FittedLog fitted = standing_twin();
  ClockFit clock;
  clock.offset_s = figure_of(-0.034);
  fitted.fit.clock = clock;
  const std::vector<sim::FaultSpec> faults = read_twin(fitted).events.simulated.faults;
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, sim::FaultKind::kLidarClock);
  EXPECT_DOUBLE_EQ(faults[0].offset_s, -0.034);
  EXPECT_EQ(faults[0].at_s, 0.0);
  EXPECT_GE(faults[0].for_s, 10.0);
}

TEST(TwinText, AClockThatMayBeRightIsRight) {
  FittedLog fitted = standing_twin();
  ClockFit clock;
  clock.offset_s = figure_of(0.004, 0.005);
  fitted.fit.clock = clock;
  EXPECT_TRUE(read_twin(fitted).events.simulated.faults.empty());
  clock.offset_s = figure_of(0.004, 0.003);
  fitted.fit.clock = clock;
  EXPECT_EQ(read_twin(fitted).events.simulated.faults.size(), 1U);
}

TEST(TwinText, ListsTheObjectsThatStand) {
  FittedLog fitted = standing_twin();
  BuildingFit building;
  fitted.fit.building = building;
  EXPECT_EQ(differences_text(fitted), "");
  building.standing = {{{1.5, -2.25, 0.3}, {0.4, 0.65}}, {{-3.0, 4.0, -1.2}, {0.1, 0.2}}};
  building.gone = {{{0.0, 0.0, 0.0}, {1.0, 0.1}}};
  fitted.fit.building = building;
  const std::vector<sim::Change> changes = read_twin_differences(fitted).changes;
  ASSERT_EQ(changes.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(changes[i].kind, sim::Change::Kind::kAdd);
    ASSERT_EQ(changes[i].objects.size(), 1U);
    const MapBox& box = building.standing[i];
    const sim::Pose2 pose = sim::to_planar(changes[i].objects[0].T_map_object);
    EXPECT_NEAR(pose.x, box.T_map_box.x, 1e-6);
    EXPECT_NEAR(pose.y, box.T_map_box.y, 1e-6);
    EXPECT_NEAR(pose.yaw, box.T_map_box.yaw, 1e-6);
    const auto& shape = std::get<sim::BoxShape>(changes[i].objects[0].shape);
    EXPECT_NEAR(shape.size.x(), box.size.x(), 1e-6);
    EXPECT_NEAR(shape.size.y(), box.size.y(), 1e-6);
  }
  EXPECT_FALSE(read_twin(fitted).world.differences);  // its world has them
}

}  // namespace
}  // namespace castaway::testbed
