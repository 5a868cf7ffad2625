#include "sim/people/gait.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

constexpr double kGaitStep = 0.05;  // [s]

class GaitTest : public ::testing::Test {
 protected:
  /// States of a person who walks along x at `speed`.
  std::vector<PersonState> walked(double speed, double seconds) const {
    PersonState state;
    state.position = {-9.0, 0.0};
    state.velocity = {speed, 0.0};
    stand(state);
    std::vector<PersonState> states{state};
    for (double t = 0.0; t < seconds; t += kGaitStep) {
      const PersonState before = state;
      state.position.x() += speed * kGaitStep;
      walk(space_, before, kGaitStep, state);
      states.push_back(state);
    }
    return states;
  }

  TestHall hall_{20.0};
  WalkSpace space_{hall_.map};
};

TEST_F(GaitTest, StepsGrowWithTheRootOfTheSpeed) {
  EXPECT_NEAR(step_length(1.34), 0.706, 1e-3);
  EXPECT_DOUBLE_EQ(step_length(2.0), 2.0 * step_length(0.5));
}

TEST_F(GaitTest, APlantedFootStaysWhereItIs) {
  const auto states = walked(1.34, 6.0);
  int planted = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const std::size_t foot = states[i - 1].gait_phase < 0.5 ? 0 : 1;
    EXPECT_EQ(states[i].feet[foot], states[i - 1].feet[foot]);
    planted += foot == 0 ? 1 : 0;
  }
  EXPECT_NEAR(planted / static_cast<double>(states.size()), 0.5, 0.1);
}

TEST_F(GaitTest, FeetLandHalfAStepAheadOfTheBody) {
  const auto states = walked(1.34, 6.0);
  int landings = 0;
  for (std::size_t i = 20; i < states.size(); ++i) {
    const bool before = states[i - 1].gait_phase < 0.5;
    const bool after = states[i].gait_phase < 0.5;
    if (before == after) continue;
    const std::size_t landed = after ? 0 : 1;
    const Eigen::Vector2d foot = states[i].feet[landed] - states[i].position;
    EXPECT_NEAR(foot.x(), 0.5 * step_length(1.34), 1e-9);
    EXPECT_NEAR(foot.y(), landed == 0 ? kFootSpread : -kFootSpread, 1e-9);
    ++landings;
  }
  EXPECT_NEAR(landings, 5.0 * 1.34 / step_length(1.34), 2.0);
}

TEST_F(GaitTest, FeetNeverLagFarBehind) {
  for (const double speed : {0.3, 0.8, 1.34, 2.0}) {
    const auto states = walked(speed, 8.0);
    for (std::size_t i = 60; i < states.size(); ++i) {
      const PersonState& state = states[i];
      for (const Eigen::Vector2d& foot : state.feet) {
        EXPECT_LT((foot - state.position).norm(), 0.75 * step_length(speed) + 0.15);
      }
    }
  }
}

TEST_F(GaitTest, WhoStopsBringsTheFeetTogether) {
  PersonState state = walked(1.34, 3.0).back();
  state.velocity.setZero();
  for (int i = 0; i < 60; ++i) {
    const PersonState before = state;
    walk(space_, before, kGaitStep, state);
  }
  EXPECT_LT((state.feet[0] - state.position - Eigen::Vector2d(0.0, kFootSpread)).norm(), 0.081);
  EXPECT_LT((state.feet[1] - state.position + Eigen::Vector2d(0.0, kFootSpread)).norm(), 0.081);
  const PersonState at_rest = state;
  walk(space_, at_rest, kGaitStep, state);
  EXPECT_EQ(state.feet, at_rest.feet);
  EXPECT_EQ(state.gait_phase, at_rest.gait_phase);
}

TEST_F(GaitTest, NoFootIsPutIntoAWall) {
  PersonState state;
  state.position = {9.6, 0.0};
  state.velocity = {1.5, 0.0};
  stand(state);
  for (int i = 0; i < 40; ++i) {
    const PersonState before = state;
    walk(space_, before, kGaitStep, state);
    for (const Eigen::Vector2d& foot : state.feet) EXPECT_LT(foot.x(), 10.0);
  }
}

TEST_F(GaitTest, WhoIsPutElsewhereStandsThere) {
  PersonState before;
  stand(before);
  PersonState state = before;
  state.position = {5.0, 5.0};
  walk(space_, before, kGaitStep, state);
  EXPECT_NEAR((state.feet[0] - state.position).norm(), kFootSpread, 1e-12);
}

}  // namespace
}  // namespace castaway::sim
