// Discovery of wheels by tags of all dialects and by kinematics, through `load_robot`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/load_robot.hpp"
#include "tests/sim/robot/urdf_parts_for_tests.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two pairs of wheels, one of which is selected by tags.
class WheelDiscovery : public RobotFiles {
 protected:
  [[nodiscard]] RobotModel load(const std::string& tags, const RobotOptions& options = {}) const {
    return load_robot(
        write("a.urdf", robot_urdf(chassis_urdf() + wheel_urdf("fl", 0.1, 0.12) +
                                   wheel_urdf("fr", 0.1, -0.12) + wheel_urdf("bl", -0.1, 0.12) +
                                   wheel_urdf("br", -0.1, -0.12) + tags)),
        options);
  }
  static std::vector<std::string> joints(const RobotModel& robot) {
    std::vector<std::string> names;
    for (const DriveWheel& wheel : robot.wheels) names.push_back(wheel.joint);
    return names;
  }
};

TEST_F(WheelDiscovery, ByGazeboClassicTags) {
  const RobotModel robot = load(R"(<gazebo><plugin name="d" filename="libgazebo_ros_diff_drive.so">
    <leftJoint>bl_joint</leftJoint><rightJoint>br_joint</rightJoint>
    <wheelSeparation>0.24</wheelSeparation><wheelDiameter>0.1</wheelDiameter></plugin></gazebo>)");
  EXPECT_EQ(robot.wheels_found_by, "gazebo-classic");
  EXPECT_THAT(joints(robot), ElementsAre("bl_joint", "br_joint"));
  EXPECT_TRUE(robot.warnings.empty());  // Separation and diameter agree.
  EXPECT_EQ(robot.casters.size(), 2U);  // Wheels that are not driven slide.
}

TEST_F(WheelDiscovery, ByGazeboClassicSkidSteerTags) {
  const RobotModel robot = load(R"(<gazebo><plugin name="d" filename="libskid.so">
    <leftFrontJoint>fl_joint</leftFrontJoint><rightFrontJoint>fr_joint</rightFrontJoint>
    <leftRearJoint>bl_joint</leftRearJoint><rightRearJoint>br_joint</rightRearJoint>
    </plugin></gazebo>)");
  EXPECT_EQ(robot.wheels_found_by, "gazebo-classic");
  EXPECT_THAT(joints(robot), ElementsAre("fl_joint", "fr_joint", "bl_joint", "br_joint"));
}

TEST_F(WheelDiscovery, ByGazeboRos2Tags) {
  const RobotModel robot = load(R"(<gazebo><plugin name="d" filename="libgazebo_ros_diff_drive.so">
    <left_joint> fl_joint </left_joint><right_joint>fr_joint</right_joint>
    <wheel_separation>0.30</wheel_separation><wheel_diameter>0.2</wheel_diameter>
    </plugin></gazebo>)");
  EXPECT_EQ(robot.wheels_found_by, "gazebo-ros2");
  EXPECT_THAT(joints(robot), ElementsAre("fl_joint", "fr_joint"));
  EXPECT_DOUBLE_EQ(robot.track, 0.24);
  EXPECT_DOUBLE_EQ(robot.wheel_radius, 0.05);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("the gazebo-ros2 tag says 0.3000 m")));
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("the gazebo-ros2 tag says 0.1000 m")));
}

TEST_F(WheelDiscovery, ByGzSimTags) {
  const RobotModel robot = load(R"(<gazebo><plugin filename="gz-sim-diff-drive-system"
    name="gz::sim::systems::DiffDrive"><left_joint>fl_joint</left_joint>
    <left_joint>bl_joint</left_joint><right_joint>fr_joint</right_joint>
    <right_joint>br_joint</right_joint></plugin></gazebo>)");
  EXPECT_EQ(robot.wheels_found_by, "gz-sim");
  EXPECT_THAT(joints(robot), ElementsAre("fl_joint", "fr_joint", "bl_joint", "br_joint"));
}

const char* const kRos2Control = R"(<ros2_control name="s" type="system">
  <joint name="bl_joint"><command_interface name="velocity"/></joint>
  <joint name="br_joint"><command_interface name="velocity"/></joint>
  <joint name="fl_joint"><state_interface name="velocity"/></joint></ros2_control>)";

TEST_F(WheelDiscovery, ByRos2Control) {
  const RobotModel robot = load(kRos2Control);
  EXPECT_EQ(robot.wheels_found_by, "ros2_control");
  EXPECT_THAT(joints(robot), ElementsAre("bl_joint", "br_joint"));
}

TEST_F(WheelDiscovery, ByTheParametersOfRos2Control) {
  write("c.yaml", "");
  RobotOptions options;
  options.read_yaml = [](const std::string&) {
    using xacro::Dict;
    using xacro::List;
    const Dict drive{{"left_wheel_names", {List{{std::string("fl_joint")}}}},
                     {"right_wheel_names", {List{{std::string("fr_joint")}}}},
                     {"wheel_separation", {0.5}}};
    return xacro::Value{Dict{{"controller", {Dict{{"ros__parameters", {drive}}}}}}};
  };
  const RobotModel robot =
      load("<gazebo><plugin><parameters>c.yaml</parameters></plugin></gazebo>", options);
  EXPECT_EQ(robot.wheels_found_by, "ros2_control");
  EXPECT_THAT(joints(robot), ElementsAre("fl_joint", "fr_joint"));
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("tag says 0.5000 m")));
}

TEST_F(WheelDiscovery, ByTransmissions) {
  const RobotModel robot = load(R"(
    <transmission name="a"><joint name="fl_joint"><hardwareInterface>
      hardware_interface/VelocityJointInterface</hardwareInterface></joint></transmission>
    <transmission name="b"><joint name="fr_joint"><hardwareInterface>
      hardware_interface/VelocityJointInterface</hardwareInterface></joint></transmission>)");
  EXPECT_EQ(robot.wheels_found_by, "transmission");
  EXPECT_THAT(joints(robot), ElementsAre("fl_joint", "fr_joint"));
}

TEST_F(WheelDiscovery, ByKinematicsWhereTagsNameNobody) {
  const RobotModel robot = load(R"(<gazebo><plugin filename="x"><left_joint>ghost</left_joint>
    <right_joint>ghoul</right_joint></plugin></gazebo>)");
  EXPECT_EQ(robot.wheels_found_by, "kinematics");
  EXPECT_EQ(robot.wheels.size(), 4U);
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("names no pair of wheels")));
}

TEST_F(WheelDiscovery, LeavesCastersAndWhatDoesNotReachTheFloorAlone) {
  const RobotModel robot = load_robot(write(
      "b.urdf",
      robot_urdf(chassis_urdf() + wheel_urdf("l", 0.0, 0.12) + wheel_urdf("r", 0.0, -0.12) +
                 wheel_urdf("caster_l", -0.1, 0.1) + wheel_urdf("caster_r", -0.1, -0.1) +
                 wheel_urdf("pan_l", 0.1, 0.05, 0.01) + wheel_urdf("pan_r", 0.1, -0.05, 0.01))));
  EXPECT_THAT(joints(robot), ElementsAre("l_joint", "r_joint"));
  EXPECT_EQ(robot.casters.size(), 2U);
  EXPECT_EQ(robot.locked_joints.size(), 4U);
}

TEST_F(WheelDiscovery, FindsWheelsBehindASuspension) {
  std::string inside = chassis_urdf();
  for (const char* side : {"l", "r"}) {
    inside += fmt::format(R"(<link name="drop_{0}"/><joint name="drop_{0}_joint" type="prismatic">
      <parent link="base_link"/><child link="drop_{0}"/><axis xyz="0 0 1"/>
      <limit lower="0" upper="0.02" effort="1" velocity="1"/></joint>)",
                          side);
  }
  inside +=
      wheel_urdf("l", 0.0, 0.12, 0.05, "drop_l") + wheel_urdf("r", 0.0, -0.12, 0.05, "drop_r");
  const RobotModel robot = load_robot(write("c.urdf", robot_urdf(inside)));
  EXPECT_THAT(joints(robot), ElementsAre("l_joint", "r_joint"));
  EXPECT_DOUBLE_EQ(robot.track, 0.24);
}

TEST_F(WheelDiscovery, SaysThatWheelsHangBelowATurningBase) {
  const std::string turret =
      "<link name=\"turret\"/><joint name=\"turn\" type=\"continuous\"><parent "
      "link=\"base_link\"/><child link=\"turret\"/><axis xyz=\"0 0 1\"/></joint>";
  const std::string urdf =
      robot_urdf(chassis_urdf() + turret + wheel_urdf("l", 0.0, 0.12, 0.05, "turret") +
                 wheel_urdf("r", 0.0, -0.12, 0.05, "turret"));
  EXPECT_THAT(error_text([&] { (void)load_robot(write("a.urdf", urdf)); }),
              testing::HasSubstr("hang below joint 'turn' of type continuous, which moves freely"));
}

TEST_F(WheelDiscovery, MeasuresTheTrackBetweenTheMiddlesOfWheels) {
  std::string left = wheel_urdf("l", 0.0, 0.12);
  std::string right = wheel_urdf("r", 0.0, -0.12);
  left.replace(left.find("<origin rpy"), 7, "<origin xyz=\"0 0.03 0\"");
  right.replace(right.find("<origin rpy"), 7, "<origin xyz=\"0 -0.03 0\"");
  const RobotModel robot = load_robot(write("d.urdf", robot_urdf(chassis_urdf() + left + right)));
  EXPECT_NEAR(robot.track, 0.30, 1e-12);
}

}  // namespace
}  // namespace castaway::sim
