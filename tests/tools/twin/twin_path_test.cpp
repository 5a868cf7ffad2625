// The motion of a log, and the files in which its twin follows it.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/twin_logs.hpp"
#include "tools/base/formats/time_list.hpp"
#include "tools/base/formats/tum.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

std::vector<StampedPose> read_twin_path(const FittedLog& fitted) {
  const TemporaryFolder folder;
  return read_tum(folder.put("path.tum", path_text(fitted)));
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
  fitted.log.scans[3].T_map_base.x = fitted.log.scans[7].T_map_base.x = 9.0;
  const std::vector<StampedPose> path = read_twin_path(fitted);
  ASSERT_EQ(path.size(), 101U);  // what is missing is interpolated
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_EQ(path[k].stamp, milliseconds(100 * k));
    EXPECT_NEAR(path[k].T_map_base.x, 1.0, 1e-6);
  }
}

TEST(TwinPath, IsDenserThanScansThatAreFarApart) {
  FittedLog fitted = standing_twin();
  fitted.log.scans = {fitted.log.scans[0], fitted.log.scans[5], fitted.log.scans[7]};
  const std::vector<StampedPose> path = read_twin_path(fitted);
  ASSERT_EQ(path.size(), 8U);
  for (std::size_t k = 0; k < path.size(); ++k) EXPECT_EQ(path[k].stamp, milliseconds(100 * k));
}

TEST(TwinScanTimes, AreThoseOfTheLogSinceTheFirstAlignedScan) {
  FittedLog fitted = standing_twin();
  // Scans that could not be aligned: before, within and after those that could.
  fitted.log.stamps = {milliseconds(4900),  milliseconds(5000),  milliseconds(5033),
                       milliseconds(14999), milliseconds(15000), milliseconds(15100)};
  EXPECT_EQ(scan_times_text(fitted.log), "0.000000000\n0.033000000\n9.999000000\n10.000000000\n");
  const TemporaryFolder folder;
  EXPECT_EQ(read_times(folder.put("scan_times.txt", scan_times_text(fitted.log))),
            (std::vector<Stamp>{milliseconds(0), milliseconds(33), milliseconds(9999),
                                milliseconds(10000)}));
}

TEST(AxleInBase, IsBehindTheDriveWhereverThatIs) {
  EXPECT_EQ(axle_in_base(standing_twin()), SE2{});
  FittedLog fitted = turning_twin(0.25);
  EXPECT_NEAR(axle_in_base(fitted).x, -0.25, 1e-4);
  fitted.fit.odometry.emplace().errors.T_base_drive = {0.1, 0.2, 0.5 * std::numbers::pi};
  const SE2 T_base_axle = axle_in_base(fitted);
  EXPECT_NEAR(T_base_axle.x, 0.1, 1e-4);
  EXPECT_NEAR(T_base_axle.y, 0.2 - 0.25, 1e-4);
  EXPECT_NEAR(T_base_axle.yaw, 0.5 * std::numbers::pi, 1e-9);
}

TEST(TwinPath, HasTheLidarAtTheSamePlaceWhereverTheDriveIs) {
  FittedLog fitted = turning_twin(0.25, 0.4);
  const Eigen::Isometry3d T_base_laser = fitted.log.scans.front().scan.T_base_laser;
  for (const SE2& T_base_drive : {SE2{}, SE2{0.1, -0.05, 0.08}, SE2{-0.4, 0.2, -1.2}}) {
    fitted.fit.odometry.emplace().errors.T_base_drive = T_base_drive;
    const Eigen::Isometry3d T_axle_laser = read_twin_lidar(fitted).T_base_laser;
    const std::vector<StampedPose> path = read_twin_path(fitted);
    ASSERT_EQ(path.size(), fitted.log.scans.size());
    for (const std::size_t k : {std::size_t{0}, std::size_t{33}, std::size_t{100}}) {
      const Eigen::Isometry3d in_log =
          localization::to_se3(fitted.log.scans[k].T_map_base) * T_base_laser;
      const Eigen::Isometry3d in_twin = localization::to_se3(path[k].T_map_base) * T_axle_laser;
      EXPECT_TRUE(in_twin.isApprox(in_log, 1e-5)) << k;
    }
    EXPECT_NEAR(path[0].T_map_base.x, (fitted.log.scans[0].T_map_base * axle_in_base(fitted)).x,
                1e-5);
  }
}

}  // namespace
}  // namespace castaway::testbed
