#include "sim/people/reaction.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

/// A person at the origin who has seen the robot.
Agent watcher(Behaviour behaviour) {
  Agent agent = agent_at({0.0, 0.0});
  agent.behaviour = behaviour;
  agent.sees_robot = true;
  return agent;
}

RobotBody robot_at(double x) { return square_robot({x, 0.0, 3.14159265358979}); }

TEST(Reaction, RegularAndImpassivePeopleGoOn) {
  for (const Behaviour behaviour : {Behaviour::kRegular, Behaviour::kImpassive}) {
    Agent agent = watcher(behaviour);
    EXPECT_FALSE(react(agent, robot_at(1.0), 0.0));
  }
}

TEST(Reaction, SurprisedPeopleStopOnceForFourSeconds) {
  Agent agent = watcher(Behaviour::kSurprised);
  EXPECT_FALSE(react(agent, robot_at(3.1), 0.0));
  const auto reaction = react(agent, robot_at(2.9), 1.0);
  ASSERT_TRUE(reaction);
  EXPECT_EQ(reaction->velocity.norm(), 0.0);
  EXPECT_TRUE(reaction->faces_robot);
  EXPECT_TRUE(react(agent, robot_at(2.9), 4.9));
  EXPECT_FALSE(react(agent, robot_at(2.9), 5.1));
  EXPECT_FALSE(react(agent, robot_at(2.9), 19.0));
  EXPECT_TRUE(react(agent, robot_at(2.9), 20.1));
}

TEST(Reaction, NeedsToSeeTheRobot) {
  for (const Behaviour behaviour :
       {Behaviour::kSurprised, Behaviour::kCurious, Behaviour::kScared, Behaviour::kThreatening}) {
    Agent agent = watcher(behaviour);
    agent.sees_robot = false;
    EXPECT_FALSE(react(agent, robot_at(1.0), 0.0));
  }
}

TEST(Reaction, CuriousPeopleComeNearAndStop) {
  Agent agent = watcher(Behaviour::kCurious);
  const auto far = react(agent, robot_at(3.5), 0.0);
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->velocity.x(), 1.34, 1e-9);
  const auto near = react(agent, robot_at(0.85), 1.0);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->velocity.norm(), 0.0);
  EXPECT_FALSE(react(agent, robot_at(0.85), 12.1));  // The person has lost interest.
}

TEST(Reaction, ScaredPeopleWalkOffUntilTheyAreSafe) {
  Agent agent = watcher(Behaviour::kScared);
  EXPECT_FALSE(react(agent, robot_at(3.5), 0.0));
  const auto reaction = react(agent, robot_at(2.0), 0.1);
  ASSERT_TRUE(reaction);
  EXPECT_NEAR(reaction->velocity.x(), -1.25 * 1.34, 1e-9);
  EXPECT_FALSE(reaction->faces_robot);
  EXPECT_TRUE(react(agent, robot_at(3.5), 0.2));
  EXPECT_FALSE(react(agent, robot_at(4.1), 0.3));
}

TEST(Reaction, ThreateningPeopleGetInTheWay) {
  Agent agent = watcher(Behaviour::kThreatening);
  // The robot at (3, 3) drives along -x: the point 0.8 m in front of it is (2.2, 3).
  const RobotBody robot = square_robot({3.0, 3.0 - 1.0, 3.14159265358979});
  const auto reaction = react(agent, robot, 0.0);
  ASSERT_TRUE(reaction);
  const Eigen::Vector2d to(2.2, 2.0);
  EXPECT_NEAR(reaction->velocity.normalized().dot(to.normalized()), 1.0, 1e-9);
  EXPECT_TRUE(react(agent, robot, 11.0));
  EXPECT_FALSE(react(agent, robot, 12.5));
}

}  // namespace
}  // namespace castaway::sim
