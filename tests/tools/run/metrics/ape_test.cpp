#include "tools/run/metrics/ape.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "castaway/stamp.hpp"

namespace castaway::testbed {
namespace {

using localization::from_seconds;

StampedPose pose(double t, double x, double y, double yaw = 0.0) {
  return {from_seconds(t), {x, y, yaw}};
}

// By hand: errors 0 (rotated by 90 degrees, but only translation counts), 5, 1. Hence max 5, mean
// 2, median 1, min 0, rmse sqrt(26 / 3), std sqrt((4 + 9 + 1) / 3).
TEST(Ape, OfAHandMadeTrajectoryIsWhatEvoComputes) {
  const std::vector<StampedPose> truth{pose(1.0, 0.0, 0.0), pose(2.0, 1.0, 0.0),
                                       pose(3.0, 2.0, 0.0)};
  const std::vector<StampedPose> estimate{pose(1.0, 0.0, 0.0, 1.57), pose(2.0, 4.0, 4.0),
                                          pose(3.0, 2.0, -1.0)};
  const auto ape = absolute_pose_error(truth, estimate);
  ASSERT_TRUE(ape);
  EXPECT_EQ(ape->pairs, 3U);
  EXPECT_DOUBLE_EQ(ape->max, 5.0);
  EXPECT_DOUBLE_EQ(ape->mean, 2.0);
  EXPECT_DOUBLE_EQ(ape->median, 1.0);
  EXPECT_DOUBLE_EQ(ape->min, 0.0);
  EXPECT_DOUBLE_EQ(ape->rmse, std::sqrt(26.0 / 3.0));
  EXPECT_DOUBLE_EQ(ape->std, std::sqrt(14.0 / 3.0));
}

TEST(Ape, MatchesTheShorterTrajectoryWithinTenMilliseconds) {
  const std::vector<StampedPose> truth{pose(0.0, 0.0, 0.0), pose(0.1, 1.0, 0.0),
                                       pose(0.2, 2.0, 0.0), pose(0.3, 3.0, 0.0)};
  const std::vector<StampedPose> estimate{pose(0.109, 1.0, 0.5), pose(0.211, 2.0, 9.0),
                                          pose(0.295, 3.0, 0.0)};
  const auto pairs = matched_by_time(truth, estimate);
  ASSERT_EQ(pairs.size(), 2U);  // 0.2 and 0.211 are too far apart
  EXPECT_EQ(pairs[0], (std::pair<std::size_t, std::size_t>(1, 0)));
  EXPECT_EQ(pairs[1], (std::pair<std::size_t, std::size_t>(3, 2)));
  EXPECT_DOUBLE_EQ(absolute_pose_error(truth, estimate)->mean, 0.25);
  const auto turned = matched_by_time(estimate, truth);
  ASSERT_EQ(turned.size(), 2U);
  EXPECT_EQ(turned[1], (std::pair<std::size_t, std::size_t>(2, 3)));
}

TEST(Ape, TakesTheEarlierOfTwoThatAreAsNear) {
  const std::vector<StampedPose> one{pose(0.104, 0.0, 0.0)};
  const std::vector<StampedPose> two{pose(0.1, 1.0, 0.0), pose(0.108, 2.0, 0.0)};
  EXPECT_EQ(matched_by_time(one, two).at(0).second, 0U);
  EXPECT_EQ(matched_by_time(two, one).at(0).first, 0U);
}

TEST(Ape, OfNothingIsNothing) {
  const std::vector<StampedPose> truth{pose(0.0, 0.0, 0.0)};
  EXPECT_FALSE(absolute_pose_error({}, {}));
  EXPECT_FALSE(absolute_pose_error(truth, {}));
  EXPECT_FALSE(absolute_pose_error({}, truth));
  EXPECT_FALSE(absolute_pose_error(truth, {pose(1.0, 0.0, 0.0)}));
}

}  // namespace
}  // namespace castaway::testbed
