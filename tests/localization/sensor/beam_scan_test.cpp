#include "localization/sensor/beam_scan.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TransformBuffer at_rest() {
  TransformBuffer buffer;
  buffer.add(Stamp(0), {});
  return buffer;
}

LaserScan scan_of(std::vector<float> ranges) {
  LaserScan scan;
  scan.angle_increment = 0.1;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  scan.ranges = std::move(ranges);
  return scan;
}

TEST(TakeBeams, TakesThemByEqualSteps) {
  // 9 beams, at most 5: step (9 - 1) / (5 - 1) = 2.
  const auto beams = take_beams(scan_of({1, 2, 3, 4, 5, 6, 7, 7.5F, 7.8F}), at_rest(), 5, 100.0);
  ASSERT_TRUE(beams);
  EXPECT_EQ(beams->returns.range, (std::vector<float>{1, 3, 5, 7, 7.8F}));
  EXPECT_TRUE(beams->misses.empty());
  EXPECT_NEAR(beams->returns.y[2], 5.0 * std::sin(0.4), 1e-6);
}

TEST(TakeBeams, KeepsThoseWithoutAReturnApart) {
  const auto beams = take_beams(scan_of({1, kInf, kNan, -kInf, 9}), at_rest(), 60, 100.0);
  ASSERT_TRUE(beams);
  EXPECT_EQ(beams->returns.range, (std::vector<float>{1}));
  ASSERT_EQ(beams->misses.size(), 1U);
  EXPECT_NEAR(beams->misses.range[0], 8.0, 1e-5);
  EXPECT_NEAR(beams->misses.y[0], 8.0 * std::sin(0.1), 1e-5);
}

TEST(TakeBeams, EndsMissesAtTheShorterOfTheTwoLimits) {
  const auto beams = take_beams(scan_of({1, kInf, 5}), at_rest(), 60, 4.0);
  ASSERT_TRUE(beams);
  EXPECT_EQ(beams->returns.size(), 1U);
  EXPECT_NEAR(beams->misses.range[0], 4.0, 1e-5);
}

TEST(TakeBeams, NeedsTheMotionAtTheScansTime) {
  EXPECT_FALSE(take_beams(scan_of({1, 2}), TransformBuffer(), 60, 100.0));
}

}  // namespace
}  // namespace castaway::localization
