// Robots whose drive differs from the simulated one, through `load_robot`.
#include <tuple>

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

class DriveKind : public RobotFiles {
 protected:
  [[nodiscard]] RobotModel load(const std::string& parts) const {
    return load_robot(write("a.urdf", robot_urdf(chassis_urdf() + parts)));
  }
  static std::string four_wheels(const std::string& name) {
    return wheel_urdf(name + "_fl", 0.1, 0.12) + wheel_urdf(name + "_fr", 0.1, -0.12) +
           wheel_urdf(name + "_bl", -0.1, 0.12) + wheel_urdf(name + "_br", -0.1, -0.12);
  }
  /// A wheel below a joint with a vertical axis.
  static std::string hung_wheel(const std::string& name, double x, double y,
                                const std::string& swivel) {
    return "<link name=\"" + name + "_fork\"/><joint name=\"" + name + "_swivel\" " + swivel +
           "<parent link=\"base_link\"/><child link=\"" + name + "_fork\"/><origin xyz=\"" +
           std::to_string(x) + " " + std::to_string(y) + " 0\"/><axis xyz=\"0 0 1\"/></joint>" +
           wheel_urdf(name, 0.0, 0.0, 0.05, name + "_fork");
  }
};

TEST_F(DriveKind, IsNotMentionedWhereItIsWhatIsSimulated) {
  EXPECT_EQ(load(wheel_urdf("l", 0.0, 0.12) + wheel_urdf("r", 0.0, -0.12)).other_drive, "");
  EXPECT_EQ(load(four_wheels("wheel")).other_drive, "");
}

TEST_F(DriveKind, IsNotedForTheSummaryOfARun) {
  EXPECT_EQ(load(wheel_urdf("l", 0.0, 0.12) + wheel_urdf("r", 0.0, -0.12)).drive_note, "");
  EXPECT_THAT(load(four_wheels("wheel")).drive_note, HasSubstr("the robot is a skid steer: its"));
  EXPECT_THAT(load(four_wheels("omni")).drive_note,
              HasSubstr("the robot moves by omni wheels: simulated as skid steer"));
}

TEST_F(DriveKind, OfMecanumAndOmniWheelsIsSaid) {
  const RobotModel mecanum = load(four_wheels("mecanum_wheel"));
  EXPECT_EQ(mecanum.other_drive, "mecanum wheels");
  EXPECT_THAT(mecanum.warnings, Contains(HasSubstr("moves by mecanum wheels: simulated as skid")));
  EXPECT_EQ(load(four_wheels("omni")).other_drive, "omni wheels");
}

TEST_F(DriveKind, OfPluginsThatMoveSidewaysIsSaid) {
  const std::string wheels = wheel_urdf("l", 0.0, 0.12) + wheel_urdf("r", 0.0, -0.12);
  EXPECT_EQ(load(wheels + R"(<gazebo><plugin name="p" filename="libgazebo_ros_planar_move.so"/>)"
                          "</gazebo>")
                .other_drive,
            "a planar_move plug-in");
}

/// The type is in the parameter file of the robot's controllers.
TEST_F(DriveKind, OfAMecanumControllerIsSaid) {
  const auto with_controller = [&](const std::string& type) {
    RobotOptions options;
    options.read_yaml = [type](const std::string&) {
      const xacro::Dict base{{"type", xacro::Value{type}}};
      return xacro::Value{xacro::Dict{
          {"controller_manager", xacro::Value{xacro::Dict{{"base", xacro::Value{base}}}}}}};
    };
    (void)write("c.yaml", "");
    return load_robot(write("a.urdf", robot_urdf(chassis_urdf() + four_wheels("wheel") +
                                                 "<gazebo><plugin name=\"p\" filename=\"gz\">"
                                                 "<parameters>c.yaml</parameters></plugin>"
                                                 "</gazebo>")),
                      options)
        .other_drive;
  };
  EXPECT_EQ(with_controller("mecanum_drive_controller/MecanumDriveController"), "mecanum wheels");
  EXPECT_EQ(with_controller("omni_wheel_drive_controller/OmniWheelDriveController"), "omni wheels");
  EXPECT_EQ(with_controller("ackermann_steering_controller/AckermannSteeringController"),
            "steered wheels");
  EXPECT_EQ(with_controller("diff_drive_controller/DiffDriveController"), "");
}

TEST_F(DriveKind, OfRollersThatFrictionModelsIsSaid) {
  const auto with_friction = [&](const std::string& friction) {
    return load(four_wheels("wheel") + "<gazebo reference=\"wheel_fl\">" + friction + "</gazebo>")
        .other_drive;
  };
  EXPECT_EQ(with_friction("<mu1>1</mu1><mu2>0</mu2><fdir1>1 -1 0</fdir1>"), "mecanum wheels");
  EXPECT_EQ(with_friction("<collision><surface><friction><ode><mu>1</mu><mu2>0.0</mu2>"
                          "<fdir1 expressed_in=\"base\">1 1 0</fdir1></ode></friction></surface>"
                          "</collision>"),
            "mecanum wheels");
  EXPECT_EQ(with_friction("<mu1>1</mu1><mu2>0</mu2><fdir1>1 0 0</fdir1>"), "");
  EXPECT_EQ(with_friction("<mu1>1</mu1><mu2>1</mu2><fdir1>1 1 0</fdir1>"), "");
}

TEST_F(DriveKind, OfRobotsThatAreCalledSoIsSaid) {
  const auto called = [&](const std::string& name) {
    std::string urdf = robot_urdf(chassis_urdf() + four_wheels("wheel"));
    const std::size_t quote = urdf.find("name=\"") + 6;
    urdf.replace(quote, urdf.find('"', quote) - quote, name);
    return load_robot(write("a.urdf", urdf)).other_drive;
  };
  EXPECT_EQ(called("my_mecanum_bot"), "mecanum wheels");
  EXPECT_EQ(called("OmniBot"), "omni wheels");
}

TEST_F(DriveKind, OfACarIsSaid) {
  const std::string steering =
      "type=\"revolute\"><limit lower=\"-0.5\" upper=\"0.5\" effort=\"1\" velocity=\"1\"/>";
  const RobotModel car = load(hung_wheel("front_left_wheel", 0.1, 0.12, steering) +
                              hung_wheel("front_right_wheel", 0.1, -0.12, steering) +
                              wheel_urdf("l", -0.1, 0.12) + wheel_urdf("r", -0.1, -0.12));
  EXPECT_EQ(car.other_drive, "steered wheels");
  EXPECT_THAT(car.warnings, Contains(HasSubstr("turns on the spot as the robot cannot")));
}

/// Like AgileX's hunter_se: `fr_left_joint` below `fr_steer_left_joint`.
TEST_F(DriveKind, OfACarIsSaidWhateverItsWheelsAreCalled) {
  const std::string limited =
      "type=\"revolute\"><limit lower=\"-0.5\" upper=\"0.5\" effort=\"1\" velocity=\"1\"/>";
  const RobotModel car =
      load(hung_wheel("fr_left", 0.1, 0.12, limited) + hung_wheel("fr_right", 0.1, -0.12, limited) +
           wheel_urdf("re_left", -0.1, 0.12) + wheel_urdf("re_right", -0.1, -0.12));
  EXPECT_EQ(car.other_drive, "steered wheels");
}

TEST_F(DriveKind, OfAThousandWheelsIsRefused) {
  std::string parts;
  for (int i = 0; i < 500; ++i) {
    parts += wheel_urdf("l" + std::to_string(i), 0.05 * i, 0.12) +
             wheel_urdf("r" + std::to_string(i), 0.05 * i, -0.12);
  }
  EXPECT_THAT(error_text([&] { (void)load(parts); }), HasSubstr("1000 driven wheels: at most 20"));
}

TEST_F(DriveKind, IsNotMentionedForAnArmThatTurnsAboutTheUpright) {
  const std::string shoulder =
      "type=\"revolute\"><limit lower=\"-2\" upper=\"2\" effort=\"1\" velocity=\"1\"/>";
  const RobotModel robot =
      load(wheel_urdf("l", 0.0, 0.12) + wheel_urdf("r", 0.0, -0.12) +
           hung_wheel("wrist", 0.1, 0.0, shoulder) + hung_wheel("elbow", -0.1, 0.0, shoulder));
  EXPECT_EQ(robot.other_drive, "");
}

TEST_F(DriveKind, OfCastersWithMotorsTagsIsTheWheelsThatDrive) {
  std::string parts = wheel_urdf("l", 0.0, 0.12) + wheel_urdf("r", 0.0, -0.12);
  for (const auto& [name, x, y] : {std::tuple{"c1", 0.15, 0.1}, std::tuple{"c2", 0.15, -0.1},
                                   std::tuple{"c3", -0.15, 0.1}, std::tuple{"c4", -0.15, -0.1}}) {
    parts += hung_wheel(name, x, y, "type=\"continuous\">");
  }
  for (const char* name : {"l", "r", "c1", "c2", "c3", "c4"}) {
    parts += std::string("<transmission name=\"t_") + name + "\"><joint name=\"" + name +
             "_joint\"><hardwareInterface>hardware_interface/VelocityJointInterface"
             "</hardwareInterface></joint></transmission>";
  }
  const RobotModel robot = load(parts);
  std::vector<std::string> driven;
  for (const DriveWheel& wheel : robot.wheels) driven.push_back(wheel.joint);
  EXPECT_THAT(driven, ElementsAre("l_joint", "r_joint"));
  EXPECT_EQ(robot.other_drive, "");
}

}  // namespace
}  // namespace castaway::sim
