#include "localization/space/stack/stacked_ground.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/space/map3d/building.hpp"

namespace castaway::localization {
namespace {

class StackedGroundTest : public testing::Test {
 protected:
  Rng rng_ = substream(1, "stacked_ground");
  test::Building building_{rng_, 4};
  const Atlas& atlas_ = building_.volume().atlas();
  StackFrame stack_{atlas_.ground(), StackConfig{}};
  StackedGround ground_{atlas_, stack_};
};

TEST_F(StackedGroundTest, EachCellWithGroundIsFreeForOneSlope) {
  std::vector<int> classes(stack_.grid().size(), 0);
  for (std::uint16_t slope = 0; slope < ground_.slopes().size(); ++slope) {
    for (const Eigen::Vector2i& cell : ground_.cells_of_slope(slope)) {
      ++classes[stack_.grid().index(cell)];
    }
  }
  std::size_t free = 0;
  for (const int count : classes) {
    ASSERT_LE(count, 1);
    free += static_cast<std::size_t>(count);
  }
  EXPECT_EQ(free, ground_.size());
}

TEST_F(StackedGroundTest, CellsAreWhereTheGroundIs) {
  const GridFrame& frame = atlas_.frame();
  for (int i = 0; i < 500; ++i) {
    const SE2 pose = building_.sample(rng_);
    const Eigen::Vector2i atlas_cell =
        frame.cell_of(frame.T_map_grid.inverse() * pose.translation());
    const auto at = ground_.cell_of(atlas_cell);
    ASSERT_TRUE(at);
    const int plane = at->cell.y() / stack_.pitch;
    EXPECT_EQ(plane, stack_.plane_of(static_cast<double>(atlas_.surface_at(atlas_cell)->z)));
    const SE2 back = ground_.pose_at(at->cell, 0.3);
    EXPECT_LT(distance(back, pose), 0.2 * 1.42);
    EXPECT_EQ(back.yaw, frame.T_map_grid.yaw + 0.3);
  }
  EXPECT_FALSE(ground_.cell_of({-1, 0}));
}

TEST_F(StackedGroundTest, TheRampHasItsSlope) {
  const SE2 on_ramp = *atlas_.to_atlas({-3.0, 7.0, 0.0}, 1.4);
  const GridFrame& frame = atlas_.frame();
  const auto at =
      ground_.cell_of(frame.cell_of(frame.T_map_grid.inverse() * on_ramp.translation()));
  ASSERT_TRUE(at);
  EXPECT_NE(at->slope, 0);
  EXPECT_NEAR(ground_.slopes()[at->slope].x(), 0.2, 0.01);
  EXPECT_NEAR(ground_.slopes()[at->slope].y(), 0.0, 0.01);
  EXPECT_TRUE(ground_.slopes()[0].isZero());
}

TEST(OrientationOn, IsThatOfARobotOnARamp) {
  Rng rng = substream(2, "stacked_ground");
  const test::Building building(rng, 0);
  for (const double yaw : {0.0, 0.7, 2.0, -2.5}) {
    const SE2 pose = *building.volume().atlas().to_atlas({-3.0, 7.0, yaw}, 1.4);
    const Eigen::Matrix3d expected = building.volume().lift(pose)->T_map_base.linear();
    EXPECT_LT((orientation_on({0.2, 0.0}, yaw) - expected).norm(), 0.02) << yaw;
  }
}

TEST(StackFrameTest, RefusesWhatIsOutOfRange) {
  Rng rng = substream(3, "stacked_ground");
  const test::Building building(rng, 0);
  const ElevationMap& ground = building.volume().atlas().ground();
  EXPECT_THROW(StackFrame(ground, {0.0, 0.3, 20.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(StackFrame(ground, {0.2, -1.0, 20.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(StackFrame(ground, {0.2, 0.3, 1e9, 2.0}), std::invalid_argument);
  EXPECT_THROW(StackFrame(ground, {0.2, 1e-6, 20.0, 2.0}), std::invalid_argument);
  EXPECT_NO_THROW(StackFrame(ground, StackConfig{}));
}

}  // namespace
}  // namespace castaway::localization
