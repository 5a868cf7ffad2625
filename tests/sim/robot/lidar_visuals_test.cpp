#include "sim/robot/robot_sensors.hpp"
#include "sim/robot/robot_visuals.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

Eigen::AlignedBox3f extent(const std::vector<SceneItem>& items) {
  Eigen::AlignedBox3f box;
  for (const SceneItem& item : items) {
    for (const Eigen::Vector3f& vertex : item.mesh.vertices) box.extend(item.T_map_mesh * vertex);
  }
  return box;
}

TEST(LidarVisuals, AreATurretOnAMast) {
  RobotModel robot;
  robot.height = 0.1;
  const auto items = lidar_visuals(robot, lidar_of(robot));
  ASSERT_EQ(items.size(), 2U);
  const Eigen::AlignedBox3f box = extent(items);
  EXPECT_NEAR(box.max().z(), 0.225F, 1e-5F);  // Around the laser's plane, 0.2 m up.
  EXPECT_LT(box.min().z(), 0.1F);             // Down to the body.
  EXPECT_LT(box.sizes().x(), 0.1F);
}

TEST(LidarVisuals, StandWhereTheLidarDoes) {
  RobotModel robot;
  robot.height = 0.5;
  LidarConfig lidar = lidar_of(robot);
  lidar.T_base_laser.translation() = Eigen::Vector3d(0.3, -0.1, 0.4);
  const auto items = lidar_visuals(robot, lidar);
  EXPECT_TRUE(items[0].T_map_mesh.translation().isApprox(Eigen::Vector3f(0.3F, -0.1F, 0.4F)));
}

TEST(LidarVisuals, AreNotNeededWhereTheFileHasALidar) {
  RobotModel robot;
  robot.lidars.emplace_back();
  EXPECT_TRUE(lidar_visuals(robot, LidarConfig{}).empty());
}

}  // namespace
}  // namespace castaway::sim
