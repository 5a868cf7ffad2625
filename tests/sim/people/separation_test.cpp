#include "sim/people/separation.hpp"

#include <gtest/gtest.h>

#include "sim/casting/ray_scene.hpp"
#include "tests/sim/support/people_scene.hpp"
#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

const RobotBody kRobotFarAway = square_robot({50.0, 50.0, 0.0});

std::vector<PersonState> states(const std::vector<Agent>& agents) {
  std::vector<PersonState> result;
  for (const Agent& agent : agents) result.push_back(agent.state);
  return result;
}

TEST(Moved, GoesStraightInTheOpenAndNoFurtherThanAStep) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  EXPECT_EQ(slide_along_walls(space, {0.0, 0.0}, {0.06, 0.08}), Eigen::Vector2d(0.06, 0.08));
  EXPECT_NEAR(slide_along_walls(space, {0.0, 0.0}, {3.0, 0.0}).x(), WalkSpace::kMaxStep, 1e-12);
}

TEST(Moved, SlidesAlongAWall) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  const Eigen::Vector2d p = slide_along_walls(space, {2.74, 0.0}, {0.08, 0.06});
  EXPECT_TRUE(space.clear(p));
  EXPECT_NEAR(p.y(), 0.06, 0.02);
  EXPECT_LT(p.x(), 2.76);
}

TEST(Moved, NeverPassesAWallWhateverIsTried) {
  const WorldSpec world = test_room();
  const WalkSpace space(body_grid(world, test_simulation().map));
  const RayScene solid(ray_primitives(world));
  Rng rng(9);
  Eigen::Vector2d p(-1.0, -2.0);
  double heading = 0.0;
  for (int i = 0; i < 100000; ++i) {
    heading += draw_between(-0.4, 0.4, rng);
    const Eigen::Vector2d to = slide_along_walls(space, p, 0.15 * heading_vector(heading));
    const double length = (to - p).norm();
    if (length > 0.0) {
      const Eigen::Vector2d d = (to - p) / length;
      ASSERT_FALSE(solid.cast({{p.x(), p.y(), 0.3}, {d.x(), d.y(), 0.0}}, length).has_value());
    }
    p = to;
  }
}

TEST(Separate, PartsTwoByHalfEach) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  std::vector<Agent> agents{agent_at({0.0, 0.0}), agent_at({0.3, 0.0})};
  separate(space, kRobotFarAway, states(agents), agents);
  EXPECT_NEAR(agents[0].state.position.x(), -0.05, 1e-9);
  EXPECT_NEAR(agents[1].state.position.x(), 0.35, 1e-9);
}

TEST(Separate, PushesPeopleOutOfTheRobot) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  const RobotBody robot = square_robot({0.0, 0.0, 0.0});
  std::vector<Agent> agents{agent_at({0.3, 0.0})};
  for (int i = 0; i < 20; ++i) separate(space, robot, states(agents), agents);
  EXPECT_NEAR(distance_to(robot, agents[0].state.position).distance, 0.2 + 0.08, 1e-9);
}

TEST(Separate, LeavesWhoIsApartAlone) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  std::vector<Agent> agents{agent_at({0.0, 0.0}), agent_at({0.41, 0.0})};
  const auto before = states(agents);
  separate(space, kRobotFarAway, before, agents);
  EXPECT_EQ(agents[0].state.position, before[0].position);
  EXPECT_EQ(agents[1].state.position, before[1].position);
}

TEST(PlaceAside, IsStraightOffTheRobotInTheOpen) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  const RobotBody robot = square_robot({0.0, 0.0, 0.0});
  const Agent agent = agent_at({0.4, 0.0});
  ASSERT_TRUE(stands_close(robot, agent));
  const auto p = place_aside(space, robot, agent);
  ASSERT_TRUE(p.has_value());
  EXPECT_GT(p->x(), 0.4);
  EXPECT_NEAR(p->y(), 0.0, 1e-9);
  EXPECT_GE(distance_to(robot, *p).distance, agent.body.radius);
  EXPECT_FALSE(stands_close(robot, agent_at(*p)));
}

TEST(PlaceAside, IsAroundTheRobotBeforeAWall) {
  const TestHall hall(6.0);
  const WalkSpace space(hall.map);
  const RobotBody robot = square_robot({2.2, 0.0, 0.0});
  const Agent agent = agent_at({2.7, 0.0});  // Between the robot and the wall at 3 m.
  ASSERT_TRUE(stands_close(robot, agent));
  const auto p = place_aside(space, robot, agent);
  ASSERT_TRUE(p.has_value());
  EXPECT_TRUE(space.clear(*p));
  EXPECT_GE(distance_to(robot, *p).distance, agent.body.radius);
}

TEST(KeepFeetOff, DrawsAFootOutOfTheRobotAndLeavesTheOther) {
  const RobotBody robot = square_robot({0.0, 0.0, 0.0});
  PersonState state;
  state.position = {0.5, 0.0};
  state.feet = {Eigen::Vector2d(0.2, 0.05), Eigen::Vector2d(0.7, -0.1)};
  keep_feet_off(robot, state);
  EXPECT_NEAR(distance_to(robot, state.feet[0]).distance, 0.18, 1e-9);
  EXPECT_GT(state.feet[0].x(), 0.2);
  EXPECT_NEAR(state.feet[0].y(), 0.05, 1e-9);
  EXPECT_EQ(state.feet[1], Eigen::Vector2d(0.7, -0.1));
}

}  // namespace
}  // namespace castaway::sim
