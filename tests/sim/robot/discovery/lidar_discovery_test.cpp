// Discovery of lidars, through `load_robot`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/load_robot.hpp"
#include "tests/sim/robot/urdf_parts_for_tests.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

/// A robot with a link `laser` 0.3 m above base_link.
class LidarDiscovery : public RobotFiles {
 protected:
  [[nodiscard]] RobotModel load(const std::string& tags) const {
    return load_robot(write(
        "a.urdf", robot_urdf(chassis_urdf() + wheel_urdf("l", 0.0, 0.12) +
                             wheel_urdf("r", 0.0, -0.12) + frame("laser_mount", "base_link", 0.2) +
                             frame("laser", "laser_mount", 0.1) + tags)));
  }
  static std::string frame(const std::string& name, const std::string& parent, double z) {
    return fmt::format(R"(<link name="{0}"/><joint name="{0}_joint" type="fixed">
      <parent link="{1}"/><child link="{0}"/><origin xyz="0 0 {2}"/></joint>)",
                       name, parent, z);
  }
  static std::string sensor(const std::string& type, const std::string& name, int samples,
                            int layers, const std::string& reference = "laser") {
    const std::string body = type.ends_with("lidar") ? "lidar" : "ray";
    return fmt::format(R"(<gazebo reference="{0}"><sensor name="{1}" type="{2}"><{3}><scan>
      <horizontal><samples>{4}</samples><min_angle>-1.5</min_angle><max_angle>1.5</max_angle>
      </horizontal><vertical><samples>{5}</samples><min_angle>-0.2</min_angle>
      <max_angle>0.2</max_angle></vertical></scan><range><min>0.1</min><max>8</max></range></{3}>
      </sensor></gazebo>)",
                       reference, name, type, body, samples, layers);
  }
};

TEST_F(LidarDiscovery, ByEveryTypeOfTag) {
  for (const char* type : {"ray", "gpu_ray", "lidar", "gpu_lidar"}) {
    const RobotModel robot = load(sensor(type, "scanner", 180, 1));
    ASSERT_EQ(robot.lidars.size(), 1U) << type;
    ASSERT_TRUE(robot.lidar && robot.lidar->specs);
    EXPECT_EQ(robot.lidar->sensor, "scanner");
    EXPECT_EQ(robot.lidar->specs->samples, 180);
    EXPECT_EQ(robot.lidar->specs->range_max, 8.0);
    EXPECT_NEAR(robot.lidar->T_base_laser.translation().z(), 0.35, 1e-9);
  }
}

TEST_F(LidarDiscovery, AllOfThemThePlanarOnesFirst) {
  const RobotModel robot = load(sensor("lidar", "cloud", 360, 16) + sensor("ray", "front", 90, 1) +
                                sensor("ray", "back", 90, 1, "laser_mount_joint"));
  ASSERT_EQ(robot.lidars.size(), 3U);
  EXPECT_EQ(robot.lidars[0].sensor, "front");
  EXPECT_EQ(robot.lidars[1].sensor, "back");
  EXPECT_EQ(robot.lidars[1].link, "laser_mount");  // By the name of its parent joint.
  EXPECT_EQ(robot.lidars[2].specs->layers, 16);
  EXPECT_DOUBLE_EQ(robot.lidars[2].specs->layer_max, 0.2);
  EXPECT_EQ(robot.lidar->sensor, "front");
}

TEST_F(LidarDiscovery, SeesAsFarRoundWithAnglesInReverseOrder) {
  std::string tags = sensor("ray", "scanner", 180, 1);
  tags.replace(tags.find("<min_angle>-1.5"), 15, "<min_angle>3.14");
  tags.replace(tags.find("<max_angle>1.5"), 14, "<max_angle>-3.14");
  const RobotModel robot = load(tags);
  ASSERT_TRUE(robot.lidar && robot.lidar->specs);
  EXPECT_EQ(robot.lidar->specs->angle_min, -3.14);
  EXPECT_EQ(robot.lidar->specs->angle_max, 3.14);
  EXPECT_EQ(robot.lidar->specs->range_max, 8.0);
  EXPECT_THAT(robot.warnings, testing::Contains(testing::HasSubstr("sensor scanner: its min_")));
}

TEST_F(LidarDiscovery, AllThatAreCalledSoWithoutSensors) {
  const RobotModel robot =
      load(frame("rear_lidar", "base_link", 0.0) + frame("front_lidar_mount", "base_link", 1.0) +
           frame("front_lidar", "front_lidar_mount", 0.0) + frame("lidar_optical", "laser", 0.01));
  ASSERT_EQ(robot.lidars.size(), 3U);
  EXPECT_EQ(robot.lidars[0].link, "lidar_optical");  // In `laser`.
  EXPECT_EQ(robot.lidars[1].link, "front_lidar");
  EXPECT_EQ(robot.lidars[2].link, "rear_lidar");
  EXPECT_THAT(robot.warnings,
              testing::Contains(testing::HasSubstr("3 links are taken for lidars")));
}

TEST_F(LidarDiscovery, OnceForTwoLinksOfOneDevice) {
  EXPECT_EQ(load(frame("laser_window", "laser_mount", 0.15)).lidars.size(), 1U);
}

TEST_F(LidarDiscovery, SaysWhichSensorsItLeavesOut) {
  const RobotModel robot = load(sensor("ray", "cliff", 3, 1) + sensor("ray", "lost", 90, 1, "no"));
  EXPECT_THAT(robot.warnings,
              testing::IsSupersetOf({testing::HasSubstr("sensor cliff: left out, since 3 beams"),
                                     testing::HasSubstr("no link is called 'no'")}));
}

TEST_F(LidarDiscovery, TakesRangeFindersForWhatTheyAre) {
  const RobotModel robot = load(sensor("ray", "cliff", 3, 1));
  ASSERT_EQ(robot.lidars.size(), 1U);
  EXPECT_FALSE(robot.lidars[0].specs.has_value());  // Found by the name of its link.
}

TEST_F(LidarDiscovery, ByTheNameThatIsNoMount) {
  const RobotModel robot = load("");
  ASSERT_EQ(robot.lidars.size(), 1U);
  EXPECT_EQ(robot.lidars[0].link, "laser");
  EXPECT_EQ(robot.lidars[0].sensor, "");
}

}  // namespace
}  // namespace castaway::sim
