#include "tools/formats/tum.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::nanoseconds;

TEST(Tum, HasEightColumnsAndSingleSpaces) {
  EXPECT_EQ(tum_line({nanoseconds(1'500'000'001), {1.0, -2.5, std::numbers::pi / 2}}),
            "1.500000001 1.000000000 -2.500000000 0.000000000 0.000000000 0.000000000 0.707106781 "
            "0.707106781\n");
}

TEST(Tum, WritesNoNegativeZero) {
  EXPECT_EQ(tum_line({nanoseconds(0), {-1e-12, 0.0, -1e-12}}),
            "0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
            "1.000000000\n");
}

TEST(Tum, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const StampedPose pose{nanoseconds(12'345'678'901), {3.25, -1.5, -3.0}};
  const auto path = folder.put("a.tum", "# timestamp ...\n\n" + tum_line(pose));
  const auto poses = read_tum(path);
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].stamp, pose.stamp);
  EXPECT_NEAR(poses[0].T_map_base.x, 3.25, 1e-9);
  EXPECT_NEAR(poses[0].T_map_base.yaw, -3.0, 1e-8);
}

TEST(Tum, NamesTheBrokenLine) {
  const TemporaryFolder folder;
  const auto path = folder.put("a.tum", "1 2 3 4 5 6 7 8\n1 2 3\n");
  EXPECT_TRUE(contains(error_of([&] { read_tum(path); }), "a.tum:2: needs 8 numbers"));
}

}  // namespace
}  // namespace castaway::testbed
