#include "sim/people/intent.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

class IntentTest : public ::testing::Test {
 protected:
  IntentTest() : goals_(make()) {}
  GoalFields make() {
    Rng rng(1);
    return {cells_, 4, rng};
  }
  Intent intent_of(std::size_t index, double now = 0.0) {
    return intend(index, agents_, goals_, robot_, now);
  }

  TestHall hall_{20.0};
  WalkCells cells_{WalkSpace(hall_.map)};
  GoalFields goals_;
  RobotBody robot_ = square_robot({-9.0, -9.0, 0.0});
  std::vector<Agent> agents_;
};

TEST_F(IntentTest, AWalkerGoesToItsWaypointAtItsSpeed) {
  agents_ = {agent_at({0.0, 0.0})};
  agents_[0].waypoint = {0.0, 1.0};
  agents_[0].state.position =
      goals_.places()[0].x() > 0.0 ? Eigen::Vector2d(-5.0, 0.0) : Eigen::Vector2d(5.0, 0.0);
  const Intent intent = intent_of(0);
  EXPECT_NEAR(intent.velocity.norm(), 1.34, 1e-9);
  EXPECT_NEAR(intent.top_speed, 1.3 * 1.34, 1e-9);
}

TEST_F(IntentTest, AWalkerRestsAtItsGoalAndThenTakesAnother) {
  agents_ = {agent_at(goals_.places()[2])};
  agents_[0].goal = 2;
  EXPECT_EQ(intent_of(0, 1.0).velocity.norm(), 0.0);
  EXPECT_GE(agents_[0].rests_until, 1.0);
  EXPECT_LE(agents_[0].rests_until, 7.0);
}

TEST_F(IntentTest, WhoStandsComesBackToItsPlace) {
  agents_ = {agent_at({1.0, 1.0}, 0.7)};
  agents_[0].errand = Errand::kStanding;
  EXPECT_EQ(intent_of(0).velocity.norm(), 0.0);
  EXPECT_EQ(intent_of(0).heading, 0.7);
  agents_[0].state.position = {1.3, 1.0};
  EXPECT_NEAR(intent_of(0).velocity.x(), -0.3, 1e-9);
}

TEST_F(IntentTest, AFollowerKeepsAbreast) {
  agents_ = {agent_at({0.0, 0.0}), agent_at({0.0, 0.65})};
  agents_[0].state.velocity = {1.0, 0.0};
  agents_[1].leader = 0;
  agents_[1].rank = 1;
  EXPECT_NEAR(intent_of(1).velocity.x(), 1.0, 1e-9);
  EXPECT_NEAR(intent_of(1).velocity.y(), 0.0, 1e-9);
  agents_[1].state.position = {-0.5, 0.65};
  EXPECT_GT(intent_of(1).velocity.x(), 1.2);
}

TEST_F(IntentTest, TheCrowdFacesTheRobotAndKeepsUpWithIt) {
  agents_ = {agent_at({-8.0, -9.0})};
  agents_[0].in_crowd = true;
  agents_[0].slot = {-8.0, -9.0};
  robot_.velocity = {0.3, 0.0};
  const Intent intent = intent_of(0);
  EXPECT_NEAR(intent.velocity.x(), 0.3, 1e-9);
  EXPECT_NEAR(std::abs(intent.heading), 3.14159265, 1e-6);
  EXPECT_FALSE(intent.avoids_robot);
}

TEST_F(IntentTest, WhoIsStuckGoesElsewhere) {
  Agent agent = agent_at({0.0, 0.0});
  Intent intent;
  intent.velocity = {1.0, 0.0};
  for (int i = 0; i < 40; ++i) note_progress(intent, 0.25, agent);
  EXPECT_GT(agent.stuck_for, 5.0);
  agents_ = {agent};
  const std::size_t goal = agents_[0].goal;
  for (int tries = 0; tries < 20 && agents_[0].goal == goal; ++tries) {
    agents_[0].stuck_for = 5.0;
    intent_of(0);
    EXPECT_EQ(agents_[0].stuck_for, 0.0);
  }
  EXPECT_NE(agents_[0].goal, goal);
  agent.state.velocity = {0.5, 0.0};
  for (int i = 0; i < 4; ++i) note_progress(intent, 0.25, agent);
  EXPECT_EQ(agent.stuck_for, 0.0);
}

TEST_F(IntentTest, WhoIsOnlyJostledIsStuck) {
  Agent agent = agent_at({0.0, 0.0});
  Intent intent;
  intent.velocity = {1.0, 0.0};
  for (int i = 0; i < 400; ++i) {
    agent.state.velocity = {i % 4 < 2 ? 0.25 : -0.25, i % 2 == 0 ? 0.2 : -0.2};
    note_progress(intent, 0.05, agent);
  }
  EXPECT_GT(agent.stuck_for, 5.0);
}

TEST_F(IntentTest, WhoWantsNothingIsNotStuck) {
  Agent agent = agent_at({0.0, 0.0});
  for (int i = 0; i < 400; ++i) note_progress({}, 0.05, agent);
  EXPECT_EQ(agent.stuck_for, 0.0);
}

}  // namespace
}  // namespace castaway::sim
