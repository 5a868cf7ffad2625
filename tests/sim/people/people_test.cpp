#include "sim/people/people.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

const RobotBody kFarRobot = square_robot({100.0, 100.0, 0.0});

PeopleConfig walkers(int count) {
  PeopleConfig config;
  config.walking = count;
  return config;
}

TEST(People, WalkAtTheirSpeedInTheOpen) {
  const TestHall hall(30.0);
  People people(walkers(4), walk_cells(hall.world, hall.map), {}, kFarRobot, named_streams(1));
  double best = 0.0;
  for (int i = 0; i < 400; ++i) {
    people.step(kFarRobot);
    const Agent& agent = people.agents()[0];
    best = std::max(best, agent.state.velocity.norm() / agent.body.desired_speed);
    EXPECT_LE(agent.state.velocity.norm(), 1.3 * agent.body.desired_speed + 1e-9);
  }
  EXPECT_NEAR(best, 1.0, 0.1);
}

TEST(People, RepeatToTheBit) {
  const TestHall hall(10.0);
  PeopleConfig config = walkers(30);
  config.behaviour.reset();
  config.in_groups = 0.4;
  const auto run = [&](std::uint64_t seed) {
    const RobotBody robot = square_robot({0.0, 0.0, 0.0});
    People people(config, walk_cells(hall.world, hall.map), {}, robot, named_streams(seed));
    for (int i = 0; i < 400; ++i) people.step(robot);
    std::vector<double> sums;
    for (const PersonState& s : people.states(0.5)) {
      sums.push_back(s.position.x() + 3.0 * s.feet[0].y() + 7.0 * s.heading);
    }
    return sums;
  };
  EXPECT_EQ(run(4), run(4));
  EXPECT_NE(run(4), run(5));
}

/// The path of people who are far apart does not depend on their number.
TEST(People, OneMoreFarAwayChangesNobodysCourse) {
  const TestHall hall(60.0);
  PeopleConfig config;
  config.placed = {{-20.0, -20.0, 0.0}};
  config.walking = 1;
  const auto course = [&](const PeopleConfig& c) {
    People people(c, walk_cells(hall.world, hall.map), {}, kFarRobot, named_streams(2));
    std::vector<Eigen::Vector2d> result;
    for (int i = 0; i < 100; ++i) {
      people.step(kFarRobot);
      result.push_back(people.agents()[1].state.position);
    }
    return std::pair(result, people.agents().back().state.position);
  };
  const auto [alone, itself] = course(config);
  config.walking = 2;
  const auto [beside, other] = course(config);
  ASSERT_GT((other - itself).norm(), 6.0);
  EXPECT_EQ(alone, beside);
}

TEST(People, NeverPassAWall) {
  const WorldSpec world = test_room();
  const RayScene solid(ray_primitives(world));
  PeopleConfig config = walkers(25);
  config.behaviour.reset();
  config.in_groups = 0.4;
  RobotBody robot = square_robot({-1.0, -2.0, 0.0});
  People people(config, walk_cells(world, test_simulation().map), {}, robot, named_streams(6));
  for (int step = 0; step < 6000; ++step) {  // 5 min of a crowd in 40 m^2.
    robot.T_map_base = {-2.9 + 5.0 * std::abs(std::sin(0.002 * step)), -2.0, 0.01 * step};
    std::vector<Eigen::Vector2d> before;
    for (const Agent& agent : people.agents()) before.push_back(agent.state.position);
    people.step(robot);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Eigen::Vector2d way = people.agents()[i].state.position - before[i];
      if (way.norm() == 0.0) continue;
      const Eigen::Vector2d d = way.normalized();
      for (const double z : {0.1, 0.5, 0.65}) {
        const Ray ray{{before[i].x(), before[i].y(), z}, {d.x(), d.y(), 0.0}};
        ASSERT_FALSE(solid.cast(ray, way.norm()).has_value()) << step << " " << i;
      }
    }
  }
}

TEST(People, KeepTheirDistanceFromEachOther) {
  const TestHall hall(8.0);
  People people(walkers(40), walk_cells(hall.world, hall.map), {}, kFarRobot, named_streams(1));
  double closest = 10.0;
  for (int step = 0; step < 1200; ++step) {
    people.step(kFarRobot);
    for (std::size_t i = 0; step > 100 && i < 40; ++i) {
      for (std::size_t j = i + 1; j < 40; ++j) {
        const auto& agents = people.agents();
        closest = std::min(closest, (agents[i].state.position - agents[j].state.position).norm());
      }
    }
  }
  EXPECT_GT(closest, 0.3);
}

TEST(People, GroupsWalkTogether) {
  const TestHall hall(30.0);
  PeopleConfig config = walkers(12);
  config.in_groups = 1.0;
  People people(config, walk_cells(hall.world, hall.map), {}, kFarRobot, named_streams(1));
  double sum = 0.0;
  int count = 0;
  for (int step = 0; step < 1200; ++step) {
    people.step(kFarRobot);
    for (const Agent& agent : people.agents()) {
      if (agent.rank == 0 || step < 200) continue;
      sum += (agent.state.position - people.agents()[agent.leader].state.position).norm();
      ++count;
    }
  }
  EXPECT_LT(sum / count, 1.5);
}

TEST(People, ARobotThatRunsIntoSomebodyIsCountedOnce) {
  const TestHall hall(10.0);
  PeopleConfig config;
  config.placed = {{1.0, 0.0, 0.0}};
  RobotBody robot = square_robot({0.0, 0.0, 0.0});
  People people(config, walk_cells(hall.world, hall.map), {}, robot, named_streams(1));
  people.step(robot);
  EXPECT_TRUE(people.hits().empty());
  robot.T_map_base.x = 0.75;  // The robot's front is at 0.95 m, the person's body begins at 0.8 m.
  people.step(robot);
  EXPECT_EQ(people.hits(), std::vector<int>{0});
  people.step(robot);
  EXPECT_TRUE(people.hits().empty());
}

TEST(People, StepAsideForARobotThatIsPutDownOnThem) {
  const TestHall hall(10.0);
  PeopleConfig config;
  config.placed = {{1.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}};
  RobotBody robot = square_robot({4.0, 4.0, 0.0});
  People people(config, walk_cells(hall.world, hall.map), {}, robot, named_streams(1));
  robot.T_map_base = {1.1, 0.0, 0.0};
  people.make_way(robot);
  EXPECT_GE(distance_to(robot, people.agents()[0].state.position).distance, 0.3 - 1e-9);
  EXPECT_EQ(people.agents()[1].state.position, Eigen::Vector2d(-3.0, 0.0));
  people.step(robot);
  EXPECT_TRUE(people.hits().empty());
}

TEST(People, ScaredPeopleEndUpFurtherAwayThanCuriousOnes) {
  const auto mean_distance = [](Behaviour behaviour) {
    const TestHall hall(12.0);
    PeopleConfig config = walkers(10);
    config.behaviour = behaviour;
    const RobotBody robot = square_robot({0.0, 0.0, 0.0});
    People people(config, walk_cells(hall.world, hall.map), {}, robot, named_streams(2));
    double sum = 0.0;
    for (int i = 0; i < 600; ++i) {
      people.step(robot);
      for (const Agent& agent : people.agents()) sum += agent.state.position.norm() / 6000.0;
    }
    return sum;
  };
  EXPECT_GT(mean_distance(Behaviour::kScared), mean_distance(Behaviour::kRegular));
  EXPECT_LT(mean_distance(Behaviour::kCurious), mean_distance(Behaviour::kRegular));
}

/// Bodies seen by lidars have the orientation of the people, also between two steps.
TEST(People, ScenesFaceAsStatesDo) {
  const TestHall hall(8.0);
  People people(walkers(6), walk_cells(hall.world, hall.map), {}, kFarRobot, named_streams(3));
  double most_turned = 0.0;
  for (int i = 0; i < 200; ++i) {
    const auto before = people.states(1.0);
    people.step(kFarRobot);
    const auto states = people.states(0.3);
    const MovingScene scene = people.scene(0.3);
    for (std::size_t k = 0; k < states.size(); ++k) {
      const Eigen::Vector2d axis = scene.bodies()[k].parts[2].axis_x;
      ASSERT_LT((axis - heading_vector(states[k].heading)).norm(), 1e-3);
      const double turned = wrap_angle(states[k].heading - before[k].heading);
      most_turned = std::max(most_turned, std::abs(turned));
    }
  }
  EXPECT_GT(most_turned, 0.03);
}

}  // namespace
}  // namespace castaway::sim
