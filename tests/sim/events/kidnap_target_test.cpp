#include "sim/events/kidnap_target.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/map/free_space.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using std::numbers::pi;

/// A hall of 10 m x 5 m.
const FreeSpace& hall() {
  static const FreeSpace space(make_grid(200, 100, 0.05, {0.0, 0.0}, Cell::kFree), 0.3);
  return space;
}

KidnapScene scene_at(const Pose2& T_map_base) { return {T_map_base, hall()}; }

double way(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

std::string error_of(const KidnapSpec& spec) {
  Rng rng(1);
  try {
    kidnap_target(spec, scene_at({5.0, 2.5, 0.0}), rng);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(KidnapTarget, GoesFarEnoughIntoFreeSpace) {
  const KidnapSpec spec{.min_distance_m = 4.0};
  const Pose2 from{2.0, 2.0, 0.0};
  Rng rng(3);
  for (int i = 0; i < 500; ++i) {
    const auto to = kidnap_target(spec, scene_at(from), rng);
    ASSERT_TRUE(to);
    ASSERT_GE(way(from, to->T_map_base), 4.0);
    ASSERT_TRUE(hall().contains(to->T_map_base.position()));
  }
}

TEST(KidnapTarget, GoesWhereItIsToldUnlessSomebodyStandsThere) {
  for (const KidnapKind kind : {KidnapKind::kTeleportTo, KidnapKind::kCarry}) {
    const KidnapSpec spec{.kind = kind, .target = Pose2{1.0, 2.0, 3.0}};
    Rng rng(1);
    KidnapScene scene = scene_at({});
    EXPECT_EQ(kidnap_target(spec, scene, rng)->T_map_base, *spec.target);
    scene.people = {{1.4, 2.0}};
    scene.keep_clear = 0.5;
    EXPECT_FALSE(kidnap_target(spec, scene, rng));
    scene.keep_clear = 0.3;
    EXPECT_TRUE(kidnap_target(spec, scene, rng));
  }
}

TEST(KidnapTarget, KeepsClearOfPeople) {
  KidnapScene scene = scene_at({1.0, 1.0, 0.0});
  scene.people = {{6.0, 2.0}, {8.0, 3.0}};
  scene.keep_clear = 1.0;
  Rng rng(5);
  for (int i = 0; i < 500; ++i) {
    const auto to = kidnap_target({}, scene, rng);
    ASSERT_TRUE(to);
    for (const auto& p : scene.people) ASSERT_GE((to->T_map_base.position() - p).norm(), 1.0);
  }
}

TEST(KidnapTarget, NudgesWithinItsBoundsAndTurnsLittle) {
  const Pose2 from{5.0, 2.5, 1.0};
  const KidnapSpec spec{.kind = KidnapKind::kNudge, .nudge = {0.4, 0.6}};
  Rng rng(7);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const Pose2 to = kidnap_target(spec, scene_at(from), rng)->T_map_base;
    ASSERT_GE(way(from, to), 0.4 - 1e-9);
    ASSERT_LE(way(from, to), 0.6 + 1e-9);
    ASSERT_LE(std::abs(wrap_angle(to.yaw - from.yaw)), 0.3);
    mean += (to.position() - from.position()) / 1000.0;
  }
  EXPECT_LT(mean.norm(), 4.0 * 0.5 / std::sqrt(2000.0));
}

TEST(KidnapTarget, NeverNudgesThroughAWall) {
  Grid grid = make_grid(200, 100, 0.05, {0.0, 0.0}, Cell::kFree);
  for (int row = 0; row < 80; ++row) grid.cells[flat_index(grid, {100, row})] = Cell::kOccupied;
  const FreeSpace free(grid, 0.1);
  const KidnapSpec spec{.kind = KidnapKind::kNudge, .nudge = {0.5, 1.0}};
  Rng rng(2);
  for (int i = 0; i < 300; ++i) {
    const auto to = kidnap_target(spec, {{4.7, 1.0, 0.0}, free}, rng);
    ASSERT_LT(to->T_map_base.x, 5.0);
  }
}

TEST(KidnapTarget, TurnsInPlaceToBothSides) {
  const Pose2 from{5.0, 2.5, 3.0};
  const KidnapSpec spec{.kind = KidnapKind::kTurn, .turn = {1.0, 2.0}};
  Rng rng(4);
  int left = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose2 to = kidnap_target(spec, scene_at(from), rng)->T_map_base;
    const double turn = wrap_angle(to.yaw - from.yaw);
    ASSERT_EQ(to.position(), from.position());
    ASSERT_GE(std::abs(turn), 1.0 - 1e-9);
    ASSERT_LE(std::abs(turn), 2.0 + 1e-9);
    left += turn > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(left, 200, 40);
}

TEST(KidnapTarget, WaitsWhereThereIsNoRoomToTurnOrToBePushed) {
  Rng rng(1);
  const Pose2 at_wall{0.1, 2.5, pi};
  EXPECT_FALSE(kidnap_target({.kind = KidnapKind::kTurn}, scene_at(at_wall), rng));
  EXPECT_FALSE(kidnap_target({.kind = KidnapKind::kNudge}, scene_at(at_wall), rng));
}

TEST(KidnapTarget, StaysWhereItSpins) {
  const Pose2 from{0.1, 2.5, 1.0};
  Rng rng(1);
  EXPECT_EQ(kidnap_target({.kind = KidnapKind::kSpin}, scene_at(from), rng)->T_map_base, from);
}

/// The corners of the hall are the farthest places from (5, 2.5).
TEST(KidnapTarget, TakesTheFarthestPlaceWhereNoneIsFarEnough) {
  for (const KidnapKind kind : {KidnapKind::kTeleportRandom, KidnapKind::kCarry}) {
    Rng rng(1);
    const auto to =
        kidnap_target({.kind = kind, .min_distance_m = 50.0}, scene_at({4.0, 2.0, 0.0}), rng);
    ASSERT_TRUE(to);
    EXPECT_TRUE(to->too_near);
    EXPECT_GT(to->T_map_base.x, 9.5);
    EXPECT_GT(to->T_map_base.y, 4.5);
    EXPECT_FALSE(kidnap_target({.kind = kind}, scene_at({4.0, 2.0, 0.0}), rng)->too_near);
  }
}

TEST(KidnapTarget, WaitsWhereTheFarthestPlaceIsTaken) {
  KidnapScene scene = scene_at({4.0, 2.0, 0.0});
  scene.people = {{5.0, 2.5}};
  scene.keep_clear = 20.0;
  Rng rng(1);
  EXPECT_FALSE(kidnap_target({.min_distance_m = 50.0}, scene, rng));
}

TEST(KidnapTarget, SaysWhyItIsImpossible) {
  KidnapSpec spec;
  spec.kind = KidnapKind::kTeleportTo;
  spec.target = Pose2{0.1, 2.0, 0.0};
  EXPECT_THAT(error_of(spec), AllOf(HasSubstr("(0.1, 2)"), HasSubstr("obstacle")));
}

}  // namespace
}  // namespace castaway::sim
