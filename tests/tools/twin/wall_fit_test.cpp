#include "tools/twin/fits/wall_fit.hpp"

#include <gtest/gtest.h>

#include "tests/tools/twin/room_log.hpp"
#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

/// Exact scans of the room that end `behind` [m] the borders of its wall cells, by a lidar whose
/// aligned poses are off by `off`.
AlignedLog room_behind(double behind, const SE2& off) {
  AlignedLog log = room_log(200);
  for (AlignedScan& aligned : log.scans) {
    const auto expected = expect_scan(log, aligned, aligned.scan.range_max);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (!expected[i].straight) continue;
      aligned.scan.ranges[i] += static_cast<float>(behind / expected[i].cosine);
    }
    aligned.T_map_base = aligned.T_map_base * off;
  }
  return log;
}

TEST(WallFit, LearnsHowFarWallsLieBehindTheirBorders) {
  const AlignedLog log = room_behind(0.03, {});
  const WallOffsets walls = learn_walls(log, 0.0);
  const auto expected = expect_scan(log, log.scans.front(), 12.0);
  double sum = 0.0;
  double count = 0.0;
  for (const ExpectedBeam& beam : expected) {
    if (!beam.straight) continue;
    sum += walls.at(beam.cell);
    count += 1.0;
  }
  EXPECT_NEAR(sum / count, 0.03, 0.012);  // Cells with few measurements stay near the usual offset.
}

TEST(WallFit, WallsAreSharpestFromWhereTheLidarWas) {
  for (const SE2& off : {SE2{0.02, 0.0, 0.0}, SE2{-0.02, 0.01, 0.0}, SE2{0.0, -0.02, 0.0}, SE2{}}) {
    AlignedLog log = room_behind(0.03, off);
    EXPECT_LE(wall_variance(log, off.inverse()), wall_variance(log, {}));
    sharpen_walls(log);
    EXPECT_NEAR(log.T_start_base.x, -off.x, 0.005);
    EXPECT_NEAR(log.T_start_base.y, -off.y, 0.005);
    EXPECT_EQ(log.T_start_base.yaw, 0.0);
    const AlignedLog exact = room_behind(0.03, {});
    EXPECT_LT(localization::distance(log.scans[7].T_map_base, exact.scans[7].T_map_base), 0.007);
  }
}

TEST(WallFit, MovesPosesByNoMoreThanThreeCentimetres) {
  AlignedLog log = room_behind(0.0, {0.08, 0.0, 0.0});
  sharpen_walls(log);
  EXPECT_EQ(log.T_start_base.x, -0.03);
}

TEST(WallFit, OnlyALidarWithAWideViewLooksAround) {
  AlignedLog log = room_log(1);
  EXPECT_TRUE(looks_around(log));
  std::vector<float>& ranges = log.scans.front().scan.ranges;
  ranges.resize(271);
  EXPECT_TRUE(looks_around(log));
  ranges.resize(241);
  EXPECT_FALSE(looks_around(log));
  log.scans.clear();
  EXPECT_FALSE(looks_around(log));
}

}  // namespace
}  // namespace castaway::testbed
