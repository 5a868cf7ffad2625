#include "tools/twin/twin_text.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/room_log.hpp"
#include "tools/formats/tum.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/scenario/sections/lidar_spec.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

constexpr double kTwinDegree = std::numbers::pi / 180.0;

Figure figure_of(double value, double half = 1e-3) { return {value, {value - half, value + half}}; }

/// 0.1 s between scans of 181 beams to the front, by a lidar that is mounted ahead and turned.
AlignedScan front_scan(int index) {
  AlignedScan aligned;
  LaserScan& scan = aligned.scan;
  scan.stamp = milliseconds(5000 + 100 * index);
  scan.angle_min = -90.0 * kTwinDegree;
  scan.angle_increment = kTwinDegree;
  scan.range_min = 0.15;
  scan.range_max = 25.0;
  scan.ranges.assign(181, 2.0F);
  scan.T_base_laser = localization::to_se3({0.12, -0.03, 0.2});
  scan.T_base_laser.translation().z() = 0.45;
  return aligned;
}

/// A log of a robot that stands for 10 s, without models.
FittedLog standing_twin() {
  FittedLog fitted;
  fitted.log = standing_log(room_grid());
  for (int k = 0; k <= 100; ++k) {
    fitted.log.scans.push_back(front_scan(k));
    fitted.log.scans.back().T_map_base = {1.0, 2.0, 0.5};
  }
  fitted.fit.stamps.rate_hz = 10.0;
  return fitted;
}

/// A log of a robot that turns at 2 rad/s about its axle for 10 s while it drives on by `speed`
/// [m/s]; base is `ahead` [m] of the axle.
FittedLog turning_twin(double ahead, double speed = 0.0) {
  constexpr double kRate = 2.0;  // [rad/s]
  FittedLog fitted = standing_twin();
  fitted.log.T_odom_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  const SE2 T_axle_base{ahead, 0.0, 0.0};
  const SE2 T_map_odom{1.0, 2.0, 0.5};
  for (int k = 0; k <= 1000; ++k) {
    const double turn = kRate * 0.01 * k;
    const double radius = speed / kRate;
    const SE2 T_odom_axle{radius * std::sin(turn), radius * (1.0 - std::cos(turn)), turn};
    fitted.log.T_odom_base.add(milliseconds(5000 + 10 * k), T_odom_axle * T_axle_base);
    if (k % 10 == 0) {
      fitted.log.scans[static_cast<std::size_t>(k) / 10].T_map_base =
          T_map_odom * T_odom_axle * T_axle_base;
    }
  }
  return fitted;
}

Scenario read_twin(const FittedLog& fitted, int people = 0) {
  YamlDocument document = YamlDocument::parse(twin_scenario(fitted, people), "scenario.yaml");
  return read_scenario(std::move(document), ".", "other").scenario;
}

/// The lidar of a twin, on a robot that describes another one.
sim::LidarConfig read_twin_lidar(const FittedLog& fitted) {
  const Scenario scenario = read_twin(fitted);
  EXPECT_EQ(scenario.lidars.size(), 1U);
  EXPECT_EQ(scenario.lidars.front().profile, "ideal");
  return apply_changes(sim::LidarConfig{}, scenario.lidars.front().changes);
}

std::vector<StampedPose> read_twin_path(const FittedLog& fitted) {
  const TemporaryFolder folder;
  return read_tum(folder.put("path.tum", path_text(fitted)));
}

/// Every beam of the twin's lidar points as in the log, within its plane.
void expect_beams(const sim::LidarConfig& lidar, const LaserScan& scan) {
  ASSERT_EQ(static_cast<std::size_t>(lidar.beams), scan.ranges.size());
  EXPECT_NEAR(lidar.angle_min, scan.angle_min, 1e-5);
  EXPECT_NEAR(lidar.angle_increment, scan.angle_increment, 1e-5 / lidar.beams);
}

void expect_differs(const FittedLog& fitted, bool differs) {
  EXPECT_EQ(!differences_text(fitted).empty(), differs);
  EXPECT_EQ(read_twin(fitted).world.differences.has_value(), differs);
}

TEST(TwinText, FollowsThePathOfTheLogOnItsMap) {
  const Scenario scenario = read_twin(standing_twin());
  EXPECT_EQ(scenario.name, "twin");
  EXPECT_EQ(scenario.world.file, "map.yaml");
  EXPECT_EQ(scenario.drive.path, "path.tum");
  EXPECT_EQ(scenario.robot.file, kTwinRobot);
  EXPECT_DOUBLE_EQ(scenario.duration_s, 10.0);
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
  EXPECT_EQ(scenario.odometry.ticks_per_turn, ideal.ticks_per_turn);
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_EQ(lidar.noise.sigma, 0.0);
  EXPECT_EQ(lidar.light.dropout, 0.0);
  EXPECT_TRUE(scenario.events.faults.empty());
  EXPECT_TRUE(scenario.events.kidnaps.empty());
  EXPECT_EQ(scenario.people.config.walking, 0);
  expect_differs(fitted, false);
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
  noise.bias_m = figure_of(-0.021);
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

TEST(TwinText, ReadsBackTheErrorsOfOdometry) {
  FittedLog fitted = standing_twin();
  OdometryFit odometry;
  odometry.radius_error_left = figure_of(-0.0123);
  odometry.radius_error_right = figure_of(0.0234);
  odometry.track_error = figure_of(0.0345);
  odometry.drift_along = figure_of(0.0456);
  odometry.drift_yaw_deg = figure_of(1.25);
  fitted.fit.odometry = odometry;
  const sim::OdometryConfig read = read_twin(fitted).odometry;
  EXPECT_DOUBLE_EQ(read.radius_error_left, -0.0123);
  EXPECT_DOUBLE_EQ(read.radius_error_right, 0.0234);
  EXPECT_DOUBLE_EQ(read.track_error, 0.0345);
  EXPECT_DOUBLE_EQ(read.drift_along, 0.0456);
  EXPECT_DOUBLE_EQ(read.drift_yaw_deg, 1.25);
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
  OdometryFit odometry;
  odometry.drift_along = odometry.drift_yaw_deg = figure_of(-0.001);
  fitted.fit.odometry = odometry;
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  EXPECT_EQ(lidar.noise.sigma, 0.0);
  EXPECT_EQ(lidar.noise.sigma_relative, 0.0);
  EXPECT_EQ(lidar.light.dropout, 0.0);
  EXPECT_EQ(lidar.light.dropout_far, 0.0);
  EXPECT_EQ(lidar.light.dropout_grazing, 0.0);
  EXPECT_EQ(read_twin(fitted).odometry.drift_along, 0.0);
  EXPECT_EQ(read_twin(fitted).odometry.drift_yaw_deg, 0.0);
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
  const std::vector<sim::FaultSpec> faults = read_twin(fitted).events.faults;
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
  EXPECT_TRUE(read_twin(fitted).events.faults.empty());
  clock.offset_s = figure_of(0.004, 0.003);
  fitted.fit.clock = clock;
  EXPECT_EQ(read_twin(fitted).events.faults.size(), 1U);
}

TEST(TwinText, AddsTheObjectsThatStand) {
  FittedLog fitted = standing_twin();
  BuildingFit building;
  fitted.fit.building = building;
  expect_differs(fitted, false);
  building.standing = {{{1.5, -2.25, 0.3}, {0.4, 0.65}}, {{-3.0, 4.0, -1.2}, {0.1, 0.2}}};
  building.gone = {{{0.0, 0.0, 0.0}, {1.0, 0.1}}};
  fitted.fit.building = building;
  expect_differs(fitted, true);
  const std::vector<sim::Change> changes = read_twin(fitted).world.differences->changes;
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
}

TEST(TwinMotion, LastsFromTheFirstScanToTheLast) {
  EXPECT_DOUBLE_EQ(motion_of(standing_twin().log).duration_s, 10.0);
}

TEST(TwinMotion, FindsHowFarBaseIsAheadOfTheAxle) {
  for (const double ahead : {0.25, -0.15, 0.0}) {
    EXPECT_NEAR(motion_of(turning_twin(ahead).log).axle_m, ahead, 1e-4);
    EXPECT_NEAR(motion_of(turning_twin(ahead, 0.4).log).axle_m, ahead, 1e-4);
  }
}

TEST(TwinMotion, DoesNotTellTheAxleOfARobotThatHardlyTurns) {
  EXPECT_EQ(motion_of(standing_twin().log).axle_m, 0.0);
}

TEST(TwinText, MountsTheLidarAsFarFromTheAxleAsItWas) {
  const sim::LidarConfig ahead = read_twin_lidar(turning_twin(0.25));
  EXPECT_NEAR(ahead.T_base_laser.translation().x(), 0.12 + 0.25, 1e-4);
  EXPECT_NEAR(ahead.T_base_laser.translation().y(), -0.03, 1e-6);
  const sim::LidarConfig behind = read_twin_lidar(turning_twin(-0.15));
  EXPECT_NEAR(behind.T_base_laser.translation().x(), 0.12 - 0.15, 1e-4);
}

TEST(TwinPath, IsReadBackWithTimesFromZero) {
  const FittedLog fitted = turning_twin(0.0, 0.4);
  const std::vector<StampedPose> path = read_twin_path(fitted);
  ASSERT_EQ(path.size(), 101U);
  for (std::size_t k = 0; k < path.size(); ++k) {
    const SE2& T_map_base = fitted.log.scans[k].T_map_base;
    EXPECT_EQ(path[k].stamp, milliseconds(100 * k));
    EXPECT_LT(localization::distance(path[k].T_map_base, T_map_base), 1e-4);
    EXPECT_LT(localization::yaw_distance(path[k].T_map_base, T_map_base), 1e-6);
  }
}

TEST(TwinPath, IsThatOfTheAxle) {
  const FittedLog fitted = turning_twin(0.25);
  for (const StampedPose& pose : read_twin_path(fitted)) {
    EXPECT_NEAR(pose.T_map_base.x, 1.0, 1e-4);
    EXPECT_NEAR(pose.T_map_base.y, 2.0, 1e-4);
  }
}

TEST(TwinPath, KeepsTheLidarWhereItWas) {
  const FittedLog fitted = turning_twin(-0.15, 0.4);
  const sim::LidarConfig lidar = read_twin_lidar(fitted);
  const std::vector<StampedPose> path = read_twin_path(fitted);
  ASSERT_EQ(path.size(), fitted.log.scans.size());
  for (std::size_t k = 0; k < path.size(); ++k) {
    const AlignedScan& aligned = fitted.log.scans[k];
    const Eigen::Isometry3d in_log =
        localization::to_se3(aligned.T_map_base) * aligned.scan.T_base_laser;
    const Eigen::Isometry3d in_twin = localization::to_se3(path[k].T_map_base) * lidar.T_base_laser;
    EXPECT_TRUE(in_twin.isApprox(in_log, 1e-5));
  }
}

TEST(TwinPath, LeavesOutScansThatAreNotLater) {
  FittedLog fitted = standing_twin();
  fitted.log.scans[3].scan.stamp = fitted.log.scans[2].scan.stamp;
  fitted.log.scans[7].scan.stamp = fitted.log.scans[5].scan.stamp;
  const std::vector<StampedPose> path = read_twin_path(fitted);
  ASSERT_EQ(path.size(), 99U);
  EXPECT_EQ(path[3].stamp, milliseconds(400));
}

}  // namespace
}  // namespace castaway::testbed
