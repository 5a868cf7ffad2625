// A bag of a robot with a VLP-16, played on a 3-D map: from the driver's messages to the estimate.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/support/vlp_cloud.hpp"
#include "tools/base/files/file.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/map3d/survey_map3d.hpp"
#include "tools/play/replay/recorded_log.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/run/loop.hpp"

namespace castaway::testbed {
namespace {

/// Walls and furniture of a hall of 12 m x 8 m on the floor z = 0.
std::vector<Eigen::AlignedBox3d> hall() {
  return {{Eigen::Vector3d(-0.2, 0.0, 0.0), Eigen::Vector3d(0.0, 8.0, 3.0)},
          {Eigen::Vector3d(12.0, 0.0, 0.0), Eigen::Vector3d(12.2, 8.0, 3.0)},
          {Eigen::Vector3d(0.0, -0.2, 0.0), Eigen::Vector3d(12.0, 0.0, 3.0)},
          {Eigen::Vector3d(0.0, 8.0, 0.0), Eigen::Vector3d(12.0, 8.2, 3.0)},
          {Eigen::Vector3d(2.0, 6.0, 0.0), Eigen::Vector3d(3.0, 8.0, 2.5)},
          {Eigen::Vector3d(9.0, 1.0, 0.0), Eigen::Vector3d(9.6, 2.5, 2.0)},
          {Eigen::Vector3d(6.0, 7.0, 0.0), Eigen::Vector3d(8.5, 8.0, 1.2)}};
}

/// Distance along a ray to the first box or the floor. [m]
double cast(const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  double nearest = along.z() < 0.0 ? -from.z() / along.z() : 90.0;
  for (const Eigen::AlignedBox3d& box : hall()) {
    const Eigen::Array3d a = (box.min() - from).array() / along.array();
    const Eigen::Array3d b = (box.max() - from).array() / along.array();
    const double in = a.min(b).maxCoeff();
    const double out = a.max(b).minCoeff();
    if (in > 0.0 && in <= out) nearest = std::min(nearest, in);
  }
  return nearest;
}

/// Points of all surfaces, 5 cm apart.
std::vector<Eigen::Vector3d> hall_points() {
  std::vector<Eigen::Vector3d> points;
  for (double x = 0.025; x < 12.0; x += 0.05) {
    for (double y = 0.025; y < 8.0; y += 0.05) points.emplace_back(x, y, 0.0);
  }
  for (const Eigen::AlignedBox3d& box : hall()) {
    for (double z = 0.025; z < box.max().z(); z += 0.05) {
      for (double x = box.min().x(); x <= box.max().x(); x += 0.05) {
        points.emplace_back(x, box.min().y(), z);
        points.emplace_back(x, box.max().y(), z);
      }
      for (double y = box.min().y(); y <= box.max().y(); y += 0.05) {
        points.emplace_back(box.min().x(), y, z);
        points.emplace_back(box.max().x(), y, z);
      }
    }
  }
  return points;
}

constexpr double kMount = 0.8;  // [m] Height of the lidar.

/// The true pose: a bend at 1 m/s.
SE2 pose_at(double t) { return SE2{2.0, 2.0, 0.3} * SE2{t, 0.05 * t * t, 0.1 * t}; }

/// A revolution of the lidar that begins at a time.
ros::PointCloud2 revolution_at(double t) {
  VlpCloud how;
  how.columns = 900;
  how.range = [&](double azimuth, double elevation) {
    const double turned = std::remainder(how.first_azimuth - azimuth, 2.0 * std::numbers::pi);
    const double share =
        (turned < -1e-9 ? turned + 2.0 * std::numbers::pi : turned) / (2.0 * std::numbers::pi);
    const Eigen::Isometry3d T_map_laser =
        localization::to_se3(pose_at(t + 0.1 * share)) * Eigen::Translation3d(0.0, 0.0, kMount);
    const Eigen::Vector3d along(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    return cast(T_map_laser.translation(), T_map_laser.linear() * along);
  };
  ros::PointCloud2 cloud = vlp_cloud(how);
  cloud.header = header_at(t, "velodyne");
  return cloud;
}

void write_drive(const std::filesystem::path& file) {
  ForeignBag bag(file);
  ros::TFMessage mount = ros_edge(1.0, "base_footprint", "velodyne", 0.0);
  mount.transforms[0].transform.translation.z = kMount;
  bag.add("/tf_static", 1'000'000'000, mount);
  for (int tick = 0; tick <= 120; ++tick) {
    const double t = 0.05 * tick;
    const auto logged = 1'000'000'000 + static_cast<std::int64_t>(tick) * 50'000'000;
    ros::Odometry odometry = ros_odometry_at(1.0 + t, 0.0);
    odometry.child_frame_id = "base_footprint";
    odometry.pose.pose = to_ros_pose(pose_at(0.0).inverse() * pose_at(t));
    bag.add("/odom", logged, odometry);
    if (tick % 2 != 0 || tick < 2) continue;
    ros::PointCloud2 cloud = revolution_at(t - 0.1);
    cloud.header = header_at(1.0 + t - 0.1, "velodyne");
    bag.add("/velodyne_points", logged, cloud);
  }
  bag.finish();
}

TEST(CloudReplay, FindsARobotWithAVlp16OnAPointCloud) {
  const TemporaryFolder folder;
  write_drive(folder.path() / "drive.mcap");
  const auto points = hall_points();
  std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const Eigen::Vector3d& p : points) {
    ply += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  }
  write_file(folder.path() / "hall.ply", ply);
  const ReplaySession session = read_session(
      YamlDocument::parse("log: " + (folder.path() / "drive.mcap").string() +
                              "\nmap3d: " + (folder.path() / "hall.ply").string() + "\n",
                          "session"));
  const RecordedLog log = open_log(session);
  EXPECT_TRUE(log.warnings.empty());
  EXPECT_EQ(log.map.name, "hall");
  LocalizerPlace place{log.map};
  place.volume = log.volume;
  auto localizers = build_localizers(session.localizers, place, 1);
  std::vector<std::unique_ptr<RunSink>> sinks;
  Loop loop({}, localizers, sinks);
  loop.run(*spliced_source(log, session));
  const auto estimate = localizers[0].localizer->estimate();
  ASSERT_TRUE(estimate);
  EXPECT_FALSE(estimate->lost);
  const SE2 truth = pose_at(seconds(estimate->stamp));
  EXPECT_LT(localization::distance(estimate->T_map_base, truth), 0.05);
  EXPECT_LT(localization::yaw_distance(estimate->T_map_base, truth), 0.02);
  EXPECT_NEAR(estimate->footing->z, 0.0, 0.03);
}

}  // namespace
}  // namespace castaway::testbed
