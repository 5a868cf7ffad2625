#include "tools/build/bag/bag_scan_headers.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

Frames frames_of(BagScanHeaders& headers, const std::vector<ros::LaserScan>& messages) {
  Frames frames;
  for (const ros::LaserScan& message : messages) {
    ScanFrame frame;
    frame.scan = headers.take(message, from_ros_scan(message, {}));
    frames.push_back({{}, frame});
  }
  return frames;
}

const LaserScan& scan_of(const Frame& frame) { return std::get<ScanFrame>(frame.data).scan; }

TEST(ScanHeaders, OfADriverThatFillsThemStay) {
  BagScanHeaders headers;
  Frames frames = frames_of(headers, {ros_scan_at(1.0, "laser")});
  EXPECT_TRUE(headers.complete("a", frames).empty());
  EXPECT_EQ(scan_of(frames[0]).range_max, 8.0);
  EXPECT_EQ(scan_of(frames[0]).angle_increment, 1.0);
}

TEST(ScanHeaders, WithoutAnIncrementGetItFromTheirEnds) {
  BagScanHeaders headers;
  ros::LaserScan message = ros_scan_at(1.0, "laser");  // Three beams from -1 to 1 rad.
  message.angle_increment = 0.0F;
  Frames frames = frames_of(headers, {message, message});
  EXPECT_EQ(scan_of(frames[1]).angle_increment, 1.0);
  const auto warnings = headers.complete("a", frames);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(contains(warnings[0], "a: angle_increment is 0 in 2 scans;"));
  message.angle_max = message.angle_min;
  EXPECT_TRUE(contains(error_of([&] { frames_of(headers, {message}); }), "angle_increment 0"));
}

TEST(ScanHeaders, WithoutARangeGetTheLongestReturn) {
  BagScanHeaders headers;
  ros::LaserScan message = ros_scan_at(1.0, "laser");  // Returns of 1, 2 and 3 m.
  message.range_max = 0.0F;
  ros::LaserScan longer = message;
  longer.ranges = {std::numeric_limits<float>::infinity(), 7.5F, 1.0F};
  Frames frames = frames_of(headers, {message, longer});
  const auto warnings = headers.complete("a", frames);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(contains(warnings[0],
                       "range_max is not above range_min in 2 scans; the longest "
                       "return, 7.50 m"));
  EXPECT_GT(scan_of(frames[0]).range_max, 7.5);
  EXPECT_LT(scan_of(frames[0]).range_max, 7.51);
}

}  // namespace
}  // namespace castaway::testbed
