#include "tools/build/bag/bag_clocks.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using localization::from_seconds;

Frame scan_frame(double log, double stamp, const std::string& lidar = "") {
  ScanFrame scan;
  scan.scan.stamp = from_seconds(stamp);
  scan.scan.lidar = lidar;
  scan.scan.ranges = {1.0F, 1.0F};
  return {from_seconds(log), scan};
}

Frame odometry_frame(double log, double stamp) {
  return {from_seconds(log), OdometryFrame{{from_seconds(stamp), {}}, {}}};
}

/// Scans at 10 Hz and odometry at 100 Hz, for 2 s; scans are stamped `ahead` [s].
Frames recorded(double ahead, double scan_delay = 0.0) {
  Frames frames;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.01 * i;
    frames.push_back(odometry_frame(t + 0.004, t));
    if (i % 10 == 5) frames.push_back(scan_frame(t + 0.005, t - scan_delay + ahead));
  }
  return frames;
}

/// Log times of all scans. [s]
std::vector<double> scan_times(const Frames& frames) {
  std::vector<double> times;
  for (const Frame& frame : frames) {
    if (std::holds_alternative<ScanFrame>(frame.data)) {
      times.push_back(localization::seconds(frame.stamp));
    }
  }
  return times;
}

TEST(BagClocks, OfOneRobotAgree) {
  EXPECT_TRUE(warn_of_clocks("a", recorded(0.0)).empty());
  EXPECT_TRUE(warn_of_clocks("a", recorded(0.0, 0.1)).empty());
  EXPECT_TRUE(warn_of_clocks("a", {}).empty());
}

TEST(BagClocks, ThatDifferAreToldWithTheirOffset) {
  const auto ahead = warn_of_clocks("a", recorded(0.5));
  ASSERT_EQ(ahead.size(), 1U);
  EXPECT_TRUE(contains(ahead[0], "a: scans of the lidar are stamped 0.50 s ahead of odometry"));
  EXPECT_TRUE(contains(ahead[0], "--clock-offset 0.50 corrects it"));
  const auto behind = warn_of_clocks("a", recorded(-0.5));
  ASSERT_EQ(behind.size(), 1U);
  EXPECT_TRUE(
      contains(behind[0], "0.50 s behind odometry, by their log times; --clock-offset -0.5"));
}

TEST(BagClocks, AreCorrectedByTheirOffset) {
  Frames frames = recorded(0.5);
  shift_scans(0.5, frames);
  EXPECT_TRUE(warn_of_clocks("a", frames).empty());
}

TEST(BagClocks, OfASweepAreThoseOfItsLastBeam) {
  Frames frames;
  for (int i = 0; i < 10; ++i) {
    frames.push_back(odometry_frame(0.1 * i, 0.1 * i));
    Frame frame = scan_frame(0.1 * i, 0.1 * i - 0.2);
    std::get<ScanFrame>(frame.data).scan.time_increment = from_seconds(0.2);
    frames.push_back(frame);
  }
  EXPECT_TRUE(warn_of_clocks("a", frames).empty());
}

TEST(BagClocks, ThatStepBackTellATimeOnce) {
  Frames frames = {odometry_frame(0.0, 0.0), scan_frame(0.1, 0.1),     odometry_frame(0.2, 0.2),
                   scan_frame(0.3, 0.05),    odometry_frame(0.4, 0.1), scan_frame(0.5, 0.05, "b"),
                   scan_frame(0.6, 0.2),     odometry_frame(0.7, 0.2)};
  const auto warnings = remove_repeated_times("a", frames);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_TRUE(contains(warnings[0], "1 message of odometry is stamped earlier than one before"));
  EXPECT_TRUE(contains(warnings[1], "1 message of the lidar is stamped earlier")) << warnings[1];
  EXPECT_EQ(scan_times(frames), (std::vector<double>{0.1, 0.5, 0.6}));
  EXPECT_EQ(frames.size(), 6U);
}

TEST(EarlyScans, WaitForOdometry) {
  Frames frames = recorded(0.5);
  await_odometry(frames);
  std::optional<Stamp> newest;
  int early = 0;
  for (const Frame& frame : frames) {
    if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      newest = odometry->odometry.stamp;
    } else if (std::get<ScanFrame>(frame.data).scan.stamp > *newest) {
      ++early;
    }
  }
  EXPECT_EQ(early, 5);  // Those of the last half second.
  EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end(),
                             [](const Frame& a, const Frame& b) { return a.stamp < b.stamp; }));
}

TEST(EarlyScans, ByLessThanADriversDelayDoNotWait) {
  Frames frames = recorded(0.1);
  const std::vector<double> before = scan_times(frames);
  await_odometry(frames);
  EXPECT_EQ(scan_times(frames), before);
}

}  // namespace
}  // namespace castaway::testbed
