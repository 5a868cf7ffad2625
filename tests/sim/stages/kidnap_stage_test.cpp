#include "sim/stages/kidnap_stage.hpp"

#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/stages/drive_space.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

class KidnapStageTest : public testing::Test {
 protected:
  KidnapStage stage(const std::vector<KidnapSpec>& kidnaps) {
    config_.events.kidnaps = kidnaps;
    return {config_, spaces_, scene_, [](const std::string&) { return Rng(3); }};
  }
  KidnapOutcome at(KidnapStage& stage, nanoseconds now) {
    return stage.advance({now, T_map_base_, 0.0, false, [this] { return people_; }}, rng_);
  }

  SimulationConfig config_ = test_simulation();
  Spaces spaces_;
  RayScene scene_{ray_primitives(config_.world)};
  Pose2 T_map_base_{-1.0, -2.0, 0.5};
  std::vector<Eigen::Vector2d> people_;
  Rng rng_{1};
};

TEST_F(KidnapStageTest, MovesAtOnceWhatTakesNoTime) {
  KidnapStage kidnaps = stage({{.when = {.value = 1.0}, .min_distance_m = 2.0}});
  EXPECT_FALSE(at(kidnaps, milliseconds(999)).done);
  const KidnapOutcome outcome = at(kidnaps, seconds(1));
  ASSERT_TRUE(outcome.done);
  EXPECT_EQ(outcome.done->stamp, seconds(1));
  EXPECT_EQ(outcome.done->since, seconds(1));
  EXPECT_EQ(outcome.done->T_map_from, T_map_base_);
  EXPECT_FALSE(kidnaps.holds());
  EXPECT_FALSE(at(kidnaps, seconds(2)).done);
}

TEST_F(KidnapStageTest, HoldsWhatIsCarriedAndPutsItDown) {
  KidnapStage kidnaps = stage({{.kind = KidnapKind::kCarry,
                                .when = {.value = 1.0},
                                .target = Pose2{2.5, 2.0, 1.0},
                                .lift = {.height = 0.5, .seconds = 4.0, .covered = true}}});
  const KidnapOutcome begun = at(kidnaps, seconds(1));
  ASSERT_TRUE(begun.picked_up);
  EXPECT_EQ(begun.picked_up->by, OrText<KidnapKind>(KidnapKind::kCarry));
  EXPECT_FALSE(begun.done);
  EXPECT_TRUE(kidnaps.holds());
  EXPECT_TRUE(kidnaps.covered());
  EXPECT_FALSE(kidnaps.is_off());
  const Eigen::Isometry3d T_map_held = kidnaps.held_at(seconds(3));
  EXPECT_NEAR(T_map_held.translation().z(), 0.5, 1e-9);
  nanoseconds now = seconds(1);
  KidnapOutcome outcome;
  while (!outcome.done && now < seconds(60)) outcome = at(kidnaps, now += milliseconds(2));
  ASSERT_TRUE(outcome.done);
  EXPECT_EQ(outcome.done->since, seconds(1));
  EXPECT_EQ(outcome.done->stamp, now);
  EXPECT_GE(now, seconds(5));
  EXPECT_EQ(outcome.done->T_map_to, (Pose2{2.5, 2.0, 1.0}));
  EXPECT_FALSE(kidnaps.holds());
  EXPECT_FALSE(kidnaps.covered());
}

TEST_F(KidnapStageTest, DoesOneAfterTheOther) {
  KidnapStage kidnaps = stage({{.kind = KidnapKind::kSpin, .when = {.value = 1.0}},
                               {.when = {.value = 2.0}, .min_distance_m = 1.0}});
  ASSERT_TRUE(at(kidnaps, seconds(1)).picked_up);
  EXPECT_FALSE(at(kidnaps, seconds(2)).done);
  const KidnapOutcome down = at(kidnaps, seconds(5));
  ASSERT_TRUE(down.done);
  EXPECT_EQ(down.done->kind, KidnapKind::kSpin);
  const KidnapOutcome second = at(kidnaps, milliseconds(5002));
  ASSERT_TRUE(second.done);
  EXPECT_EQ(second.done->kind, KidnapKind::kTeleportRandom);
}

TEST_F(KidnapStageTest, WaitsUntilNobodyStandsAtTheTarget) {
  KidnapStage kidnaps = stage(
      {{.kind = KidnapKind::kTeleportTo, .when = {.value = 1.0}, .target = Pose2{2.5, 2.0, 0.0}}});
  people_ = {{2.6, 2.0}};
  EXPECT_FALSE(at(kidnaps, seconds(1)).done);
  people_.clear();
  EXPECT_TRUE(at(kidnaps, seconds(2)).done);
}

TEST_F(KidnapStageTest, SwitchesOffForAPowerCycle) {
  KidnapStage kidnaps =
      stage({{.kind = KidnapKind::kSpin, .when = {.value = 1.0}, .power_cycle = true},
             {.when = {.value = 9.0}, .min_distance_m = 1.0}});
  at(kidnaps, seconds(1));
  EXPECT_TRUE(kidnaps.is_off());
  ASSERT_TRUE(at(kidnaps, seconds(5)).done);
  EXPECT_FALSE(kidnaps.is_off());
  EXPECT_TRUE(kidnaps.was_power_cycle());
  ASSERT_TRUE(at(kidnaps, seconds(9)).done);
  EXPECT_FALSE(kidnaps.was_power_cycle());
}

TEST_F(KidnapStageTest, RefusesWhatCanNeverBe) {
  EXPECT_THROW(stage({{.kind = KidnapKind::kTeleportTo, .target = Pose2{9.0, 9.0, 0.0}}}),
               std::runtime_error);
  EXPECT_THROW(stage({{.kind = KidnapKind::kCarry, .target = Pose2{0.3, 0.2, 0.0}}}),
               std::runtime_error);
  EXPECT_THROW(stage({{.when = {.value = -1.0}}}), std::invalid_argument);
  config_.events.kidnaps = {{.when = {KidnapTrigger::On::kPoisson, 5.0, 0}}};
  EXPECT_THROW(KidnapStage(config_, spaces_, scene_, {}), std::invalid_argument);
}

/// Thousands of kidnaps of every kind, each starting where the last one ended, never end in an
/// obstacle or outside the room.
TEST_F(KidnapStageTest, NeverPutsTheRobotIntoAnythingOrOutside) {
  const std::vector<KidnapKind> kinds{KidnapKind::kTeleportRandom, KidnapKind::kNudge,
                                      KidnapKind::kTurn, KidnapKind::kLookAlike};
  std::vector<KidnapSpec> specs;
  for (const KidnapKind kind : kinds) {
    const int times = kind == KidnapKind::kLookAlike ? 20 : 3400;
    specs.push_back(
        {.kind = kind, .when = {KidnapTrigger::On::kTime, 1.0, times}, .min_distance_m = 2.0});
  }
  KidnapStage kidnaps = stage(specs);
  const FreeSpace touching = spaces_.landing(config_, config_.robot.footprint_radius);
  std::map<KidnapKind, int> count;
  for (nanoseconds now = seconds(1); now < seconds(3600); now += milliseconds(100)) {
    const KidnapOutcome outcome = at(kidnaps, now);
    if (!outcome.done) continue;
    T_map_base_ = outcome.done->T_map_to;
    ASSERT_TRUE(touching.contains(T_map_base_.position())) << static_cast<int>(outcome.done->kind);
    ++count[outcome.done->kind];
  }
  EXPECT_EQ(count[KidnapKind::kTeleportRandom], 3400);
  EXPECT_GT(count[KidnapKind::kNudge], 3300);
  EXPECT_EQ(count[KidnapKind::kTurn], 3400);
  EXPECT_EQ(count[KidnapKind::kLookAlike], 20);
}

}  // namespace
}  // namespace castaway::sim
