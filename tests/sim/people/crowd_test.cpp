#include "sim/people/crowd.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

/// Share of beams on people in the second half of a minute, around a stationary robot.
double reached(double wanted, int people, double lidar_height) {
  const TestHall hall(12.0);
  LidarConfig lidar;
  lidar.T_base_laser.translation() = Eigen::Vector3d(0.0, 0.0, lidar_height);
  PeopleConfig config;
  config.walking = people;
  config.blocked_share = wanted;
  const RobotBody robot = square_robot({0.0, 0.0, 0.3});
  const RayScene walls(ray_primitives(hall.world));
  People crowd(config, walk_cells(hall.world, hall.map), lidar, robot, named_streams(3));
  const Lidar caster(lidar);
  LidarDraws rng;
  int on_people = 0;
  int beams = 0;
  for (int step = 0; step < 1200; ++step) {
    if (step % 10 == 0) crowd.gather(robot, walls);
    crowd.step(robot);
    if (step < 600 || step % 20 != 0) continue;
    const MovingScene scene = crowd.scene(1.0);
    for (int i = 0; i < lidar.beams; ++i, ++beams) {
      const Beam beam = caster.cast({walls, scene}, to_isometry(robot.T_map_base), i, rng);
      on_people += is_person(beam.object) ? 1 : 0;
    }
  }
  return static_cast<double>(on_people) / beams;
}

TEST(Crowd, BlocksTheWantedShareOfBeamsAtShinHeight) {
  EXPECT_NEAR(reached(0.2, 12, 0.2), 0.2, 0.04);
  EXPECT_NEAR(reached(0.4, 24, 0.2), 0.4, 0.04);
  EXPECT_NEAR(reached(0.6, 36, 0.2), 0.6, 0.05);
}

TEST(Crowd, BlocksItAtTorsoHeight) { EXPECT_NEAR(reached(0.6, 16, 1.0), 0.6, 0.06); }

TEST(Crowd, OfFewIsWhatTheyCanDo) {
  const double share = reached(0.6, 4, 0.2);
  EXPECT_GT(share, 0.08);
  EXPECT_LT(share, 0.35);
}

TEST(Crowd, CallsWalkersOnly) {
  const TestHall hall(12.0);
  const WalkSpace space(hall.map);
  const RayScene walls(ray_primitives(hall.world));
  const MovingScene nobody;
  std::vector<Agent> agents{agent_at({3.0, 0.0}), agent_at({-3.0, 0.0})};
  agents[0].errand = Errand::kStanding;
  Crowd crowd(0.5, LidarConfig{});
  crowd.plan(square_robot({0.0, 0.0, 0.0}), space, {walls, nobody}, agents);
  EXPECT_FALSE(agents[0].in_crowd);
  EXPECT_TRUE(agents[1].in_crowd);
  EXPECT_LT(agents[1].slot.norm(), 2.5);
}

}  // namespace
}  // namespace castaway::sim
