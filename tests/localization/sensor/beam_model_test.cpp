#include "localization/sensor/beam_model.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// Cells of 0.5 m; the wall is from x = 2.0 to 2.5, 1.75 m ahead of the pose.
const OccupancyGrid kMap = test::string_map({"....#"}, 0.5);
const SE2 kPose{0.25, 0.25, 0.0};

double weight(const BeamScan& scan, double range_max) {
  return BeamModel({}, kMap).weight(scan, kPose, range_max);
}

TEST(BeamModel, AddsUpItsFourParts) {
  const BeamModel model({}, kMap);
  // At the wall: hit 0.5 * exp(0) = 0.5, rand 0.5 / 10 = 0.05; not short.
  EXPECT_NEAR(model.return_probability(1.75, 1.75, 10.0), 0.55, 1e-12);
  // 0.4 m = 2 sigma before it: hit 0.5 * exp(-2) = 0.067668, short 0.05 * 0.1 * exp(-0.1 * 1.35) =
  // 0.004369, rand 0.05.
  EXPECT_NEAR(model.return_probability(1.35, 1.75, 10.0), 0.067668 + 0.004369 + 0.05, 1e-6);
  // As far behind it: the same without short.
  EXPECT_NEAR(model.return_probability(2.15, 1.75, 10.0), 0.067668 + 0.05, 1e-6);
  // A miss: max is 0.05; hit is 0 if 8.25 m lie between, and 0.5 with the wall at the maximum
  // range.
  EXPECT_NEAR(model.miss_probability(1.75, 10.0), 0.05, 1e-12);
  EXPECT_NEAR(model.miss_probability(10.0, 10.0), 0.55, 1e-12);
}

TEST(BeamModel, WeighsByTheSumOfCubes) {
  // 0.55^3 = 0.166375; 0.122036^3 = 0.0018175; 0.05^3 = 0.000125.
  EXPECT_NEAR(weight({test::forward_beams({1.75F}), {}}, 10.0), 1.166375, 1e-6);
  EXPECT_NEAR(weight({test::forward_beams({1.75F, 1.35F}), test::forward_beams({10.0F})}, 10.0),
              1.0 + 0.166375 + 0.0018175 + 0.000125, 1e-6);
}

TEST(BeamModel, ExpectsTheLongestRangeWhereTheWallIsBeyondIt) {
  // The lidar's maximum range is 1.5 m: a miss, as expected; hit 0.5 and max 0.05.
  EXPECT_NEAR(weight({{}, test::forward_beams({1.5F})}, 1.5), 1.166375, 1e-6);
}

TEST(BeamModel, CastsFromTheLidarNotFromBase) {
  ScanPoints points = test::forward_beams({1.75F});
  points.origin_x[0] = 0.5F;  // 1.25 m in front of the wall, where the beam ends
  points.range[0] = 1.25F;
  EXPECT_NEAR(weight({points, {}}, 10.0), 1.166375, 1e-6);
}

TEST(BeamModel, RefusesFiguresOutOfTheirRange) {
  EXPECT_THROW(BeamModel({.z_short = -0.1}, kMap), std::invalid_argument);
  EXPECT_THROW(BeamModel({.lambda_short = 0.0}, kMap), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
