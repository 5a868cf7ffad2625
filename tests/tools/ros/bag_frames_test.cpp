#include "tools/ros/bag_frames.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

Eigen::Isometry3d at(double x, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, z));
}

TEST(BagFrames, HangEverythingBelowBaseLink) {
  const BagFrames frames({{"base_link", at(0.0, 0.1)}, {"mast", at(0.2, 0.5)}},
                         {{"front", "laser", at(0.3, 0.3)}});
  const auto edges = frames.message({}).transforms;
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[0].child_frame_id, "base_link");
  EXPECT_EQ(edges[1].child_frame_id, "laser");
  EXPECT_NEAR(edges[1].transform.translation.z, 0.2, 1e-12);
  EXPECT_EQ(edges[2].child_frame_id, "mast");
}

TEST(BagFrames, DoWithoutBaseLink) {
  const BagFrames frames({{"base_footprint", at(0.0, 0.0)}}, {{"front", "laser", at(0.3, 0.3)}});
  const auto edges = frames.message({}).transforms;
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_EQ(edges[0].header.frame_id, "base_footprint");
  EXPECT_EQ(edges[0].child_frame_id, "laser");
}

TEST(BagFrames, GiveEachLidarItsOwn) {
  const BagFrames frames({}, {{"a", "laser", at(0.1, 0.0)}, {"b", "laser", at(0.2, 0.0)}});
  EXPECT_EQ(frames.frame_of("a"), "laser");
  EXPECT_EQ(frames.frame_of("b"), "b_frame");
  EXPECT_EQ(frames.message({}).transforms.size(), 2U);
}

TEST(BagFrames, NoticeAMountThatMoves) {
  BagFrames frames({}, {{"a", "laser", at(0.1, 0.0)}});
  EXPECT_FALSE(frames.set_mount("a", at(0.1, 0.0)));
  EXPECT_TRUE(frames.set_mount("a", at(0.2, 0.0)));
  EXPECT_NEAR(frames.message({}).transforms.at(0).transform.translation.x, 0.2, 1e-12);
  EXPECT_TRUE(frames.set_mount("unknown", at(0.0, 0.0)));
}

}  // namespace
}  // namespace castaway::testbed
