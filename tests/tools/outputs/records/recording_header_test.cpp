#include "tools/outputs/records/recording_header.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_map.hpp"

namespace castaway::testbed {
namespace {

RunInfo named_run() {
  RunInfo info;
  info.scenario = "here";
  info.world = "small";
  info.robot = "round";
  info.localizers = {"first", "second"};
  return info;
}

LaserScan scan_of(const std::string& lidar) {
  LaserScan scan;
  scan.lidar = lidar;
  scan.angle_min = -1.0F;
  scan.angle_increment = 0.25F;
  scan.ranges.assign(8, 2.0F);
  return scan;
}

TEST(RecordingHeader, NamesTheRun) {
  const auto header = recording_header(named_run(), recorded_map(), 0.2);
  EXPECT_EQ(header.at("scenario"), "here");
  EXPECT_EQ(header.at("localizers").size(), 2);
  EXPECT_EQ(header.at("robot_radius_m"), 0.2);
  EXPECT_TRUE(header.at("lidars").empty());
}

TEST(RecordingHeader, AddsEachLidarOnce) {
  auto header = recording_header(named_run(), recorded_map(), 0.2);
  EXPECT_EQ(recorded_lidar(scan_of("front"), 1, header), 0);
  EXPECT_EQ(recorded_lidar(scan_of("rear"), 2, header), 1);
  EXPECT_EQ(recorded_lidar(scan_of("front"), 1, header), 0);
  ASSERT_EQ(header.at("lidars").size(), 2);
  EXPECT_EQ(header.at("lidars")[1].at("name"), "rear");
}

}  // namespace
}  // namespace castaway::testbed
