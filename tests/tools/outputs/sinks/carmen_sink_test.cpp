#include "tools/outputs/sinks/carmen_sink.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "castaway/stamp.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/build/recorded/carmen_source.hpp"

namespace castaway::testbed {
namespace {

OdometryFrame carmen_odometry(double t) {
  return {{localization::from_seconds(t), {0.5 * t, 0.0, 0.0}}, std::nullopt};
}

/// A scan whose first beam is at `t`.
ScanRecord carmen_scan(double t) {
  ScanRecord record = record_at(t, {});
  record.scan.stamp = record.stamp;
  record.scan.angle_min = -1.0;
  record.scan.angle_increment = 0.5;
  record.scan.range_max = 8.0;
  record.scan.ranges = {1.0F, 2.0F, 3.0F};
  record.scan.T_base_laser = Eigen::Translation3d(0.2, 0.0, 0.3);
  return record;
}

TEST(CarmenSink, PutsLinesInOrderOfTheirStamps) {
  const TemporaryFolder folder;
  CarmenSink sink(folder.path());
  for (const double t : {0.0, 0.5, 1.0}) sink.on_odometry(carmen_odometry(t));
  sink.on_scan(carmen_scan(0.75));  // Delivered after the odometry at 1 s.
  sink.finish({}, {});
  CarmenSource source(folder.path() / "log.carmen");
  std::vector<double> scans;
  while (const auto frame = source.next()) {
    const auto* scan = std::get_if<ScanFrame>(&frame->data);
    if (scan == nullptr) continue;
    scans.push_back(localization::seconds(scan->scan.stamp));
    ASSERT_TRUE(scan->true_pose);
    EXPECT_NEAR(scan->true_pose->T_map_base.x, 0.075, 1e-12);
    EXPECT_EQ(scan->scan.ranges, (std::vector<float>{1.0F, 2.0F, 3.0F}));
    EXPECT_NEAR(scan->scan.T_base_laser.translation().x(), 0.2, 1e-12);
  }
  EXPECT_EQ(scans, std::vector<double>{0.75});
  const std::string log = read_file(folder.path() / "log.carmen");
  EXPECT_LT(log.find("ROBOTLASER1"), log.find("ODOM 0.5 0 0 0.5"));
  EXPECT_EQ(log.find("PARAM robot_front_laser_max 8 "), 0U);
}

TEST(CarmenSink, HoldsLinesBackNoLongerThanASweep) {
  const TemporaryFolder folder;
  CarmenSink sink(folder.path());
  for (int i = 0; i < 1000; ++i) sink.on_odometry(carmen_odometry(0.01 * i));
  sink.finish({}, {});
  const std::string log = read_file(folder.path() / "log.carmen");
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 1000);
}

TEST(CarmenSink, NumbersSeveralLidars) {
  const TemporaryFolder folder;
  CarmenSink sink(folder.path());
  sink.on_odometry(carmen_odometry(0.0));
  ScanRecord rear = carmen_scan(0.0);
  rear.scan.lidar = "rear";
  sink.on_scan(carmen_scan(0.0));
  sink.on_scan(rear);
  sink.finish({}, {});
  const std::string log = read_file(folder.path() / "log.carmen");
  EXPECT_TRUE(contains(log, "ROBOTLASER1 "));
  EXPECT_TRUE(contains(log, "ROBOTLASER2 "));
}

TEST(CarmenSink, TurnsAnUpsideDownLidarRound) {
  ScanRecord record = carmen_scan(0.0);
  LaserScan& scan = record.scan;
  scan.T_base_laser = Eigen::Translation3d(0.1, 0.0, 0.2) *
                      Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  const PlanarScan planar = planar_view(scan);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.beam_angle(i);
    const Eigen::Vector3d p =
        scan.T_base_laser *
        Eigen::Vector3d(scan.ranges[i] * std::cos(angle), scan.ranges[i] * std::sin(angle), 0.0);
    const std::size_t j = scan.ranges.size() - 1 - i;
    const double turned = planar.angle_min + scan.angle_increment * static_cast<double>(j);
    const Eigen::Vector2d q =
        planar.T_base_laser *
        Eigen::Vector2d(planar.ranges[j] * std::cos(turned), planar.ranges[j] * std::sin(turned));
    EXPECT_NEAR((p.head<2>() - q).norm(), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace castaway::testbed
