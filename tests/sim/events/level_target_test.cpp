#include "sim/events/level_target.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/events/kidnap_target.hpp"
#include "tests/sim/support/bridge_plane.hpp"

namespace castaway::sim {
namespace {

class LevelTargetTest : public testing::Test {
 protected:
  Pose2 target(const KidnapSpec& spec, const Pose2& from = {1.0, 1.0, 0.3}) {
    const KidnapScene scene{from, free_};
    return kidnap_target(spec, scene, rng_).value().T_map_base;
  }
  [[nodiscard]] double z(const Pose2& pose) const { return plane_->p_map(pose.position()).z(); }

  std::shared_ptr<const LevelPlane> plane_ = bridge_plane();
  FreeSpace free_ = FreeSpace::on_levels(plane_, 0.2);
  Rng rng_{5};
};

TEST_F(LevelTargetTest, IsOnTheLevelOrTheRampThatIsAskedFor) {
  for (int i = 0; i < 50; ++i) {
    EXPECT_NEAR(z(target({.level = 1})), 1.8, 1e-6);
    EXPECT_LT(z(target({.level = 0})), 1.8);
    EXPECT_NEAR(plane_->slope_at(target({.ramp = true}).position()), 0.3, 1e-6);
  }
}

TEST_F(LevelTargetTest, IsFarEnoughAsSeenFromAboveOrOnAnotherLevel) {
  const Pose2 from{5.0, 18.0, 0.0};  // On the ramp, of level 0.
  bool above = false;
  for (int i = 0; i < 300; ++i) {
    const Pose2 to = target({.min_distance_m = 6.0}, from);
    const bool upper = z(to) > 1.79;
    above = above || upper;
    const double away = (plane_->in_map(to).position() - Eigen::Vector2d(5.0, 2.0)).norm();
    EXPECT_TRUE(upper || away >= 6.0) << away;
  }
  EXPECT_TRUE(above);
}

TEST_F(LevelTargetTest, ALiftGoesStraightUpOrToTheNearestPlace) {
  const Pose2 up = target({.kind = KidnapKind::kElevator}, {10.0, 2.0, 0.7});
  EXPECT_NEAR(up.x, 10.0, 0.06);
  EXPECT_NEAR(up.y, 18.0, 0.06);
  EXPECT_EQ(up.yaw, 0.7);
  EXPECT_NEAR(z(up), 1.8, 1e-6);
  const Pose2 beside = target({.kind = KidnapKind::kElevator}, {10.0, 5.5, 0.7});
  EXPECT_NEAR(beside.x, 10.0, 0.06);
  EXPECT_NEAR(plane_->in_map(beside).y, 4.2, 0.1);
  const Pose2 down = target({.kind = KidnapKind::kElevator, .level = 0}, {10.0, 18.0, 0.0});
  EXPECT_EQ(z(down), 0.0);
}

TEST_F(LevelTargetTest, AGivenPoseIsOnItsLevel) {
  const KidnapSpec up{.kind = KidnapKind::kTeleportTo, .target = Pose2{10.0, 2.0, 0.1}, .level = 1};
  EXPECT_NEAR(z(target(up)), 1.8, 1e-6);
  KidnapSpec lowest = up;
  lowest.level.reset();
  EXPECT_EQ(z(target(lowest)), 0.0);
  KidnapSpec none = up;
  none.target = Pose2{1.0, 1.0, 0.0};
  EXPECT_THROW(target(none), std::runtime_error);
}

TEST_F(LevelTargetTest, RefusesGroundThatTheWorldLacks) {
  EXPECT_NO_THROW(require_wanted_ground({.level = 1}, free_));
  EXPECT_NO_THROW(require_wanted_ground({.ramp = true}, free_));
  EXPECT_THROW(require_wanted_ground({.level = 2}, free_), std::runtime_error);
  EXPECT_THROW(require_wanted_ground({.level = 1, .ramp = true}, free_), std::runtime_error);
  const FreeSpace planar(make_grid(50, 50, 0.1, {0.0, 0.0}, Cell::kFree), 0.2);
  EXPECT_THROW(require_wanted_ground({.level = 0}, planar), std::runtime_error);
  EXPECT_THROW(require_wanted_ground({.kind = KidnapKind::kElevator}, planar), std::runtime_error);
  EXPECT_NO_THROW(require_wanted_ground({}, planar));
}

}  // namespace
}  // namespace castaway::sim
