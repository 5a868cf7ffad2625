// Joint positions set by the caller, through `load_robot`.
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/load_robot.hpp"
#include "tests/sim/robot/urdf_parts_for_tests.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

const char* const kArm = R"(
  <link name="mast"/><link name="hand"/><link name="finger"/>
  <joint name="lift" type="prismatic"><parent link="base_link"/><child link="mast"/>
    <origin xyz="0 0 0.1"/><axis xyz="0 0 2"/><limit lower="0" upper="0.5" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="mast"/><child link="hand"/>
    <origin xyz="0.2 0 0"/><axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="grip" type="revolute"><parent link="hand"/><child link="finger"/>
    <origin xyz="0.1 0 0"/><axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="1" velocity="1"/>
    <mimic joint="elbow" multiplier="-0.5" offset="0.1"/></joint>)";

class JointPositions : public RobotFiles {
 protected:
  [[nodiscard]] RobotModel load(const std::map<std::string, double>& joints) const {
    RobotOptions options;
    options.joints = joints;
    return load_robot(write("a.urdf", robot_urdf(chassis_urdf() + wheel_urdf("l", 0.0, 0.12) +
                                                 wheel_urdf("r", 0.0, -0.12) + kArm)),
                      options);
  }
};

TEST_F(JointPositions, StandAtZeroWhereTheyAreNotSet) {
  const RobotModel robot = load({});
  const Eigen::Vector3d hand = robot.frames.at("hand").translation();
  EXPECT_NEAR(hand.x(), 0.2, 1e-12);
  EXPECT_TRUE(robot.frames.at("hand").linear().isIdentity(1e-12));
}

TEST_F(JointPositions, MoveWhatHangsOnThem) {
  const double floor = load({}).frames.at("mast").translation().z();
  const RobotModel robot = load({{"lift", 0.3}, {"elbow", 1.5}});
  EXPECT_NEAR(robot.frames.at("mast").translation().z(), floor + 0.3, 1e-12);
  const Eigen::Vector3d finger = robot.frames.at("finger").translation();
  EXPECT_NEAR(finger.x(), 0.2 + 0.1 * std::cos(1.5), 1e-12);
  EXPECT_NEAR(finger.y(), 0.1 * std::sin(1.5), 1e-12);
}

TEST_F(JointPositions, MoveThoseThatMimicThem) {
  const RobotModel robot = load({{"elbow", 1.0}});
  const Eigen::Matrix3d R = robot.frames.at("finger").linear();
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), 1.0 - 0.5 + 0.1, 1e-12);
}

TEST_F(JointPositions, BeyondTheirLimitsAreTakenWithAWarning) {
  EXPECT_THAT(load({{"lift", 0.9}}).warnings,
              Contains(AllOf(HasSubstr("lift"), HasSubstr("limits of 0 to 0.5"))));
}

TEST_F(JointPositions, OfNoSuchJointAreRefusedWithTheNearest) {
  EXPECT_THAT(error_text([&] { (void)load({{"elbo", 0.0}}); }), HasSubstr("did you mean 'elbow'?"));
  EXPECT_THAT(error_text([&] {
                (void)load({{"grip", 0.0}});
              }),
              HasSubstr("'grip' follows 'elbow'"));
  EXPECT_THAT(error_text([&] { (void)load({{"elbow", 1e300}}); }), HasSubstr("give radians"));
}

}  // namespace
}  // namespace castaway::sim
