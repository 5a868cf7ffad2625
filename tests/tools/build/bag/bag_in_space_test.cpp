// Bags that are played on 3-D maps: inertial measurement units, heights, and bases above the
// ground.
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "localization/geometry/se2.hpp"
#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/support/vlp_cloud.hpp"
#include "tools/build/bag/bag_reading.hpp"
#include "tools/build/bag/bag_truth.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

std::int64_t nanoseconds_of(double t) { return static_cast<std::int64_t>(t * 1e9 + 0.5); }

/// Reads a bag with these messages for a 3-D map.
BagRecording in_space(const std::function<void(ForeignBag&)>& fill,
                      const BagGround& ground = {true, {}}) {
  const TemporaryFolder folder;
  ForeignBag bag(folder.path() / "a.mcap");
  fill(bag);
  bag.add("/odom", nanoseconds_of(1.0), ros_odometry_at(1.0, 1.0));
  bag.add("/scan", nanoseconds_of(1.1), ros_scan_at(1.1, "laser"));
  bag.finish();
  const BagInventory inventory = take_inventory("a.mcap", {folder.path() / "a.mcap"});
  BagTopicOptions options;
  options.in_space = true;
  return read_bag(inventory, choose_topics(inventory, options), ground);
}

/// At rest on level ground, turning about z of its own axes.
ros::Imu ros_imu_at(double t, const std::string& frame) {
  ros::Imu imu;
  imu.header = header_at(t, frame);
  imu.angular_velocity = {0.0, 0.0, 0.5};
  imu.linear_acceleration = {0.0, 0.0, 9.81};
  return imu;
}

/// The edge from `parent` to `child` with a height and half a turn about x.
ros::TFMessage upside_down(const std::string& parent, const std::string& child, double z) {
  ros::TFMessage edge = ros_edge(1.0, parent, child, 0.0);
  edge.transforms[0].transform.translation.z = z;
  edge.transforms[0].transform.rotation = {1.0, 0.0, 0.0, 0.0};
  return edge;
}

ros::Odometry truth_at(double t, double x, double z) {
  ros::Odometry truth = ros_odometry_at(t, x);
  truth.pose.pose.position.z = z;
  return truth;
}

template <typename Kind>
std::vector<Kind> all_of(const BagRecording& recording) {
  std::vector<Kind> all;
  for (const Frame& frame : recording.frames) {
    if (const auto* one = std::get_if<Kind>(&frame.data)) all.push_back(*one);
  }
  return all;
}

TEST(BagInSpace, TurnsTheImuIntoBase) {
  const BagRecording recording = in_space([](ForeignBag& bag) {
    bag.add("/imu/data", nanoseconds_of(1.05), ros_imu_at(1.02, "imu_link"));
    bag.add("/tf_static", nanoseconds_of(1.05), upside_down("base_link", "imu_link", 0.0));
  });
  const auto readings = all_of<ImuFrame>(recording);
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(readings[0].imu.stamp, std::chrono::milliseconds(20));
  EXPECT_NEAR(readings[0].imu.angular_velocity.z(), -0.5, 1e-12);
  EXPECT_NEAR(readings[0].imu.linear_acceleration.z(), -9.81, 1e-12);
}

TEST(BagInSpace, SaysWhatItAssumesOfTheImusAxes) {
  const BagRecording recording = in_space(
      [](ForeignBag& bag) { bag.add("/imu", nanoseconds_of(1.0), ros_imu_at(1.0, "imu_link")); });
  EXPECT_EQ(all_of<ImuFrame>(recording).at(0).imu.angular_velocity.z(), 0.5);
  ASSERT_FALSE(recording.warnings.empty());
  EXPECT_TRUE(contains(recording.warnings[1],
                       "a.mcap: no transform from 'base_link' to 'imu_link'; the axes of the IMU "
                       "are assumed to be those of base"));
}

TEST(BagInSpace, LeavesOutReadingsThatLackAPart) {
  const BagRecording recording = in_space([](ForeignBag& bag) {
    ros::Imu imu = ros_imu_at(1.0, "base_link");
    bag.add("/imu", nanoseconds_of(1.0), imu);
    imu.angular_velocity_covariance.front() = -1.0;
    bag.add("/imu", nanoseconds_of(1.0), imu);
    imu = ros_imu_at(1.0, "base_link");
    imu.linear_acceleration.x = std::numeric_limits<double>::quiet_NaN();
    bag.add("/imu", nanoseconds_of(1.0), imu);
  });
  EXPECT_EQ(all_of<ImuFrame>(recording).size(), 1U);
  EXPECT_TRUE(contains(recording.warnings.at(1), "2 readings of the IMU lack turn rates"));
}

TEST(BagInSpace, TruePosesHaveHeights) {
  const auto fill = [](ForeignBag& bag) {
    for (const auto& [t, z] : {std::pair{1.0, 3.0}, {1.2, 3.2}, {1.4, 6.0}}) {
      bag.add("/ground_truth/odom", nanoseconds_of(t), truth_at(t, 0.0, z));
    }
    bag.add("/scan", nanoseconds_of(1.35), ros_scan_at(1.3, "laser"));
  };
  const auto scans = all_of<ScanFrame>(in_space(fill));
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_NEAR(scans[0].true_pose->T_footprint_base->translation().z(), 3.1, 1e-12);
  EXPECT_FALSE(scans[1].true_pose);  // Not interpolated over an elevator.
  const auto odometry = all_of<OdometryFrame>(in_space(fill));
  EXPECT_EQ(odometry.at(0).true_pose->T_footprint_base->translation().z(), 3.0);
  EXPECT_FALSE(all_of<ScanFrame>(in_space(fill, {}))[0].true_pose->T_footprint_base);
}

TEST(BagInSpace, APlanarTruthHasNoHeights) {
  const BagRecording recording = in_space([](ForeignBag& bag) {
    bag.add("/ground_truth/odom", nanoseconds_of(1.0), truth_at(1.0, 2.0, 0.0));
  });
  const auto odometry = all_of<OdometryFrame>(recording);
  EXPECT_EQ(odometry.at(0).true_pose->T_map_base.x, 2.0);
  EXPECT_FALSE(odometry.at(0).true_pose->T_footprint_base);
}

TEST(BagInSpace, KeepsRollAndPitchApartFromYaw) {
  const Eigen::Isometry3d T_map_base = Eigen::Translation3d(1.0, 2.0, 3.0) *
                                       Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                                       Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY());
  const TruePose pose = true_pose_of(to_ros_pose(T_map_base));
  EXPECT_NEAR(pose.T_map_base.yaw, 0.7, 1e-12);
  EXPECT_TRUE(
      (localization::to_se3(pose.T_map_base) * *pose.T_footprint_base).isApprox(T_map_base, 1e-12));
}

TEST(BagInSpace, MountsAreAboveTheGround) {
  const auto fill = [](ForeignBag& bag) {
    ros::TFMessage edge = ros_edge(1.0, "base_footprint", "base_link", 0.0);
    edge.transforms[0].transform.translation.z = 0.125;
    bag.add("/tf_static", nanoseconds_of(1.0), edge);
    edge = ros_edge(1.0, "base_link", "laser", 0.25);
    edge.transforms[0].transform.translation.z = 0.5;
    bag.add("/tf_static", nanoseconds_of(1.0), edge);
    bag.add("/ground_truth/odom", nanoseconds_of(1.0), truth_at(1.0, 0.0, 3.125));
  };
  const auto lift = [&](const BagGround& ground) -> Eigen::Vector3d {
    const BagRecording recording = in_space(fill, ground);
    EXPECT_TRUE(recording.warnings.empty());
    return all_of<ScanFrame>(recording).at(0).scan.T_base_laser.translation();
  };
  EXPECT_EQ(lift({true, {}}), Eigen::Vector3d(0.25, 0.0, 0.625));
  EXPECT_EQ(lift({true, 0.0}), Eigen::Vector3d(0.25, 0.0, 0.5));
  EXPECT_EQ(lift({true, 1.0}), Eigen::Vector3d(0.25, 0.0, 1.5));
  EXPECT_EQ(lift({}), Eigen::Vector3d(0.25, 0.0, 0.5));
  const auto odometry = all_of<OdometryFrame>(in_space(fill));
  EXPECT_EQ(odometry.at(0).true_pose->T_footprint_base->translation().z(), 3.0);
}

TEST(BagInSpace, PlaysTheCloudsOf3dLidars) {
  const TemporaryFolder folder;
  ForeignBag bag(folder.path() / "a.mcap");
  bag.add("/odom", nanoseconds_of(1.0), ros_odometry_at(1.0, 1.0));
  bag.add("/tf_static", nanoseconds_of(1.0), ros_edge(1.0, "base_link", "velodyne", 0.25));
  ros::PointCloud2 cloud = vlp_cloud({});
  cloud.header = header_at(1.5, "velodyne");
  bag.add("/velodyne_points", nanoseconds_of(1.625), cloud);
  bag.finish();
  const BagInventory inventory = take_inventory("a.mcap", {folder.path() / "a.mcap"});
  BagTopicOptions options;
  options.in_space = true;
  const BagRecording recording =
      read_bag(inventory, choose_topics(inventory, options), {true, 0.5});
  const ScanFrame scan = all_of<ScanFrame>(recording).at(0);
  EXPECT_EQ(scan.scan.layers.size(), 16U);
  EXPECT_EQ(scan.scan.lidar, "/velodyne_points");
  EXPECT_EQ(scan.scan.T_base_laser.translation(), Eigen::Vector3d(0.25, 0.0, 0.5));
  EXPECT_NEAR(seconds(scan.scan.beam_stamp(2)), 0.5, 1e-6);
  EXPECT_EQ(recording.frames.back().stamp, std::chrono::milliseconds(625));
}

TEST(BagInSpace, SaysThatBaseIsTakenToBeOnTheGround) {
  const BagRecording recording = in_space([](ForeignBag& bag) {
    bag.add("/tf_static", nanoseconds_of(1.0), ros_edge(1.0, "base_link", "laser", 0.25));
  });
  ASSERT_EQ(recording.warnings.size(), 1U);
  EXPECT_TRUE(contains(recording.warnings[0],
                       "base is assumed to be on the ground. State its height "
                       "by --base-height"));
}

}  // namespace
}  // namespace castaway::testbed
