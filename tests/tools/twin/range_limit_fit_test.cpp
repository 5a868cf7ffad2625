#include "tools/twin/fits/range_limit_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

constexpr float kOutOfRange = std::numeric_limits<float>::infinity();

/// Exact scans; the range of a beam depends on its index, and on the range to the wall.
AlignedLog changed_log(const std::function<float(std::size_t, float)>& change) {
  AlignedLog log = room_log(200);
  for (AlignedScan& aligned : log.scans) {
    std::vector<float>& ranges = aligned.scan.ranges;
    for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i] = change(i, ranges[i]);
  }
  return log;
}

TEST(RangeLimit, IsWhereTheReturnsEnd) {
  for (const float lost : {kOutOfRange, 12.0F, 60.0F}) {
    const auto fit =
        fit_range_limit(changed_log([&](std::size_t, float r) { return r > 5.0F ? lost : r; }));
    ASSERT_TRUE(fit.has_value());
    EXPECT_LE(fit->limit_m.value, 5.0);
    EXPECT_NEAR(fit->limit_m.value, 5.0, 0.01);
    EXPECT_EQ(fit->limit_m.interval.low, fit->limit_m.value);
    EXPECT_GE(fit->limit_m.interval.high, 5.0);
    EXPECT_LT(fit->limit_m.interval.high, 1.03 * 5.0);
    EXPECT_GE(fit->limit_m.interval.high, 1.01 * fit->limit_m.value);
  }
}

TEST(RangeLimit, CountsTheBeamsOnWallsBeyond) {
  std::size_t beyond = 0;
  const auto fit = fit_range_limit(changed_log([&](std::size_t, float r) {
    if (r > 1.02F * 5.0F) ++beyond;
    return r > 5.0F ? kOutOfRange : r;
  }));
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(static_cast<double>(fit->beams_beyond), static_cast<double>(beyond),
              0.02 * static_cast<double>(beyond));
}

TEST(RangeLimit, CountsReturnsByTheRangeOfTheWalls) {
  const auto fit =
      fit_range_limit(changed_log([](std::size_t, float r) { return r > 5.0F ? kOutOfRange : r; }));
  ASSERT_TRUE(fit.has_value());
  ASSERT_GE(fit->bins.size(), 12U);
  const double width = fit->limit_m.value / 10.0;
  EXPECT_DOUBLE_EQ(fit->bins[3].range_m, 3.5 * width);
  EXPECT_GT(fit->bins[3].beams, 0.0);
  EXPECT_EQ(fit->bins[3].returned, fit->bins[3].beams);
  EXPECT_GT(fit->bins[11].beams, 0.0);
  EXPECT_EQ(fit->bins[11].returned, 0.0);
}

TEST(RangeLimit, IsNotThereWhereAllWallsReturn) {
  EXPECT_FALSE(fit_range_limit(room_log(200)).has_value());
}

TEST(RangeLimit, IsNotThatOfTheScans) {
  AlignedLog log = room_log(200);
  for (AlignedScan& aligned : log.scans) aligned.scan.range_max = 5.0;
  EXPECT_FALSE(fit_range_limit(log).has_value());
}

// People may hide all far walls.
TEST(RangeLimit, IsNotWhatStandsBeforeTheWalls) {
  const AlignedLog log = changed_log([](std::size_t, float r) { return std::min(r, 4.0F); });
  EXPECT_FALSE(fit_range_limit(log).has_value());
}

TEST(RangeLimit, IsNotALossThatGrowsWithTheRange) {
  const AlignedLog log = changed_log([](std::size_t i, float r) {
    const bool lost = r > 5.0F || (r > 3.0F && i % 10 != 0);
    return lost ? kOutOfRange : r;
  });
  EXPECT_FALSE(fit_range_limit(log).has_value());
}

TEST(RangeLimit, NeedsWallsBeyond) {
  EXPECT_FALSE(fit_range_limit(standing_log(room_grid())).has_value());
  AlignedLog log = room_log(1);
  for (float& r : log.scans.front().scan.ranges) r = std::min(r, 12.0F);
  std::vector<float>& ranges = log.scans.front().scan.ranges;
  std::vector<float> ascending = ranges;
  std::sort(ascending.begin(), ascending.end());
  const float limit = ascending[ascending.size() - 30];
  for (float& r : ranges) r = r > limit ? kOutOfRange : r;
  EXPECT_FALSE(fit_range_limit(log).has_value());
  for (float& r : ranges) r = kOutOfRange;
  EXPECT_FALSE(fit_range_limit(log).has_value());
}

}  // namespace
}  // namespace castaway::testbed
