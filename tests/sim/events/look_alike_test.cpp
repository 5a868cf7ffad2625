#include "sim/events/look_alike.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/map/rasterise.hpp"
#include "sim/sensor/lidar.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::numbers::pi;

/// Two rooms of 4 m x 4 m with a desk each, 4.2 m apart, both open to a corridor in the south.
WorldSpec twin_rooms() {
  WorldSpec world;
  world.name = "twins";
  world.min_corner = {-0.2, -1.6};
  world.max_corner = {8.4, 4.2};
  world.objects = {box_on_floor("south", {8.6, 0.2, 1.0}, {4.1, -1.5}),
                   box_on_floor("north", {8.6, 0.2, 1.0}, {4.1, 4.1}),
                   box_on_floor("west", {0.2, 1.4, 1.0}, {-0.1, -0.7}),
                   box_on_floor("east", {0.2, 5.4, 1.0}, {8.3, 1.4})};
  for (const double x : {0.0, 4.2}) {
    const std::string room = x > 0.0 ? "right-" : "left-";
    world.objects.push_back(box_on_floor(room + "west", {0.2, 4.2, 1.0}, {x - 0.1, 2.0}));
    world.objects.push_back(box_on_floor(room + "door-west", {1.5, 0.2, 1.0}, {x + 0.75, -0.1}));
    world.objects.push_back(box_on_floor(room + "door-east", {1.5, 0.2, 1.0}, {x + 3.25, -0.1}));
    world.objects.push_back(box_on_floor(room + "desk", {1.0, 0.5, 1.0}, {x + 1.0, 3.6}));
  }
  return world;
}

LidarConfig level_lidar() {
  LidarConfig lidar;
  lidar.range_max = 8.0;
  return lidar;
}

class LookAlikesTest : public testing::Test {
 protected:
  WorldSpec world_ = twin_rooms();
  RayScene scene_{ray_primitives(world_)};
  FreeSpace free_{rasterise(world_, 0.2, 0.05), 0.2};
};

TEST_F(LookAlikesTest, FindTheSamePlaceInTheOtherRoom) {
  const LookAlikes places(scene_, free_, level_lidar());
  const Pose2 from{2.5, 2.2, 0.7};
  const auto twin = places.most_alike(from, 2.0);
  ASSERT_TRUE(twin);
  EXPECT_NEAR(twin->T_map_base.x, 6.7, 0.1);
  EXPECT_NEAR(twin->T_map_base.y, 2.2, 0.1);
  EXPECT_NEAR(wrap_angle(twin->T_map_base.yaw - 0.7), 0.0, 0.05);
  EXPECT_LT(twin->unlikeness, 0.1);
  EXPECT_DOUBLE_EQ(twin->unlikeness, places.unlikeness(from, twin->T_map_base));
}

TEST_F(LookAlikesTest, AreNoneWhereNothingIsSoFarAway) {
  const LookAlikes places(scene_, free_, level_lidar());
  EXPECT_FALSE(places.most_alike({2.5, 2.2, 0.7}, 20.0));
}

TEST_F(LookAlikesTest, KeepTheirDistance) {
  const LookAlikes places(scene_, free_, level_lidar());
  const Pose2 from{2.5, 2.2, 0.7};
  for (const double distance : {0.5, 1.5, 4.5}) {
    const auto twin = places.most_alike(from, distance);
    ASSERT_TRUE(twin);
    EXPECT_GE((twin->T_map_base.position() - from.position()).norm(), distance);
    EXPECT_TRUE(free_.contains(twin->T_map_base.position()));
  }
}

/// The oracle searches all free places on a grid of 0.25 m at headings every 5 degrees.
TEST_F(LookAlikesTest, AreNoWorseThanTheBestOfAllPlaces) {
  LidarConfig lidar = level_lidar();
  lidar.T_base_laser.translation() = Eigen::Vector3d(0.1, -0.05, 0.2);  // off centre
  const LookAlikes places(scene_, free_, lidar);
  const Pose2 from{1.8, 1.6, -2.0};
  double best = 10.0;
  for (double x = 0.1; x < 8.2; x += 0.25) {
    for (double y = -1.3; y < 4.0; y += 0.25) {
      if (!free_.contains({x, y}) || std::hypot(x - from.x, y - from.y) < 2.0) continue;
      for (int k = 0; k < 72; ++k) {
        best = std::min(best, places.unlikeness(from, {x, y, k * pi / 36.0}));
      }
    }
  }
  EXPECT_LE(places.most_alike(from, 2.0)->unlikeness, best);
}

TEST_F(LookAlikesTest, CompareOnlyWhatTheLidarLooksAt) {
  LidarConfig ahead = level_lidar();
  ahead.beams = 61;
  ahead.angle_min = -pi / 6.0;
  ahead.angle_increment = pi / 180.0;
  const LookAlikes narrow(scene_, free_, ahead);
  const LookAlikes wide(scene_, free_, level_lidar());
  // Both face the middle of the corridor's long wall; behind one of them is a door.
  const Pose2 a{2.0, -0.6, -0.5 * pi};
  const Pose2 b{4.1, -0.6, -0.5 * pi};
  EXPECT_LT(narrow.unlikeness(a, b), 0.01);
  EXPECT_GT(wide.unlikeness(a, b), 0.1);
}

TEST_F(LookAlikesTest, HoldOneScanAgainstAnotherAsTheLidarTakesThem) {
  const LidarConfig config = level_lidar();
  const LookAlikes places(scene_, free_, config);
  LidarConfig exact = config;
  exact.noise.sigma = 0.0;
  exact.beams = 180;
  exact.angle_min = -pi;
  exact.angle_increment = 2.0 * pi / 180;
  const Lidar lidar(exact);
  const Pose2 a{2.5, 2.2, 0.7};
  const Pose2 b{6.0, 1.0, -1.1};
  double sum = 0.0;
  LidarDraws draws;
  for (int i = 0; i < 180; ++i) {
    const float from_a = lidar.cast(scene_, to_isometry(a), i, draws).range;
    const float from_b = lidar.cast(scene_, to_isometry(b), i, draws).range;
    const auto capped = [](float range) { return std::min(range, 8.0F); };
    sum += std::min(std::abs(capped(from_a) - capped(from_b)), 1.0F);
  }
  EXPECT_NEAR(places.unlikeness(a, b), sum / 180.0, 1e-3);
}

}  // namespace
}  // namespace castaway::sim
