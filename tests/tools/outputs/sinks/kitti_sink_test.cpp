#include "tools/outputs/sinks/kitti_sink.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(KittiSink, WritesTheMatrixRowByRow) {
  EXPECT_EQ(kitti_line({1.0, 2.0, std::numbers::pi / 2}),
            "0.000000000 -1.000000000 0 1.000000000 1.000000000 0.000000000 0 2.000000000 0 0 1 "
            "0\n");
}

/// Of a robot at a height, nose up by a right angle.
Eigen::Isometry3d nose_up(double z) {
  return Eigen::Translation3d(0.0, 0.0, z) *
         Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitY());
}

TEST(KittiSink, OnSeveralFloorsPosesHaveHeightRollAndPitch) {
  const TemporaryFolder folder;
  KittiSink sink(folder.path());
  ScanRecord record = record_at(1.0, {});
  record.true_pose = SE2{1.0, 2.0, 0.0};
  record.true_pose->T_footprint_base = nose_up(3.5);
  sink.on_scan(record);
  sink.finish({}, {});
  EXPECT_EQ(read_file(folder.path() / "kitti" / "poses.txt"),
            "0.000000000 0.000000000 -1.000000000 1.000000000 0.000000000 1.000000000 0.000000000 "
            "2.000000000 1.000000000 0.000000000 0.000000000 3.500000000\n");
}

TEST(KittiSink, HasATimeForEachPose) {
  const TemporaryFolder folder;
  KittiSink sink(folder.path());
  sink.on_scan(record_at(1.0, {}));
  sink.on_scan(record_at(1.0, {}));  // Another lidar's.
  ScanRecord unknown = record_at(1.5, {});
  unknown.true_pose.reset();
  sink.on_scan(unknown);
  sink.on_scan(record_at(2.0, {}));
  sink.finish({}, {});
  EXPECT_EQ(read_file(folder.path() / "kitti" / "times.txt"), "1.000000000\n2.000000000\n");
  EXPECT_EQ(read_file(folder.path() / "kitti" / "poses.txt"),
            kitti_line({0.1, 0.0, 0.0}) + kitti_line({0.2, 0.0, 0.0}));
}

}  // namespace
}  // namespace castaway::testbed
