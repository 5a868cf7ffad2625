#include "sim/robot/bodies/skid_steer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/robot/bodies/robot_physics.hpp"
#include "sim/robot/load_robot.hpp"
#include "tests/support/robot_files.hpp"

namespace castaway::sim {
namespace {

RobotModel mule() { return load_robot(CASTAWAY_ROBOTS "/mule/mule.urdf.xacro"); }

/// Displacement [m] of base after one turn on the spot.
double moved_by_a_turn(const RobotModel& robot) {
  WorldSpec floor;
  floor.min_corner = {-5.0, -5.0};
  floor.max_corner = {5.0, 5.0};
  RobotPhysics physics(floor, robot, {}, {0.5, 1.0, 0.5, 2.0}, std::chrono::milliseconds(2));
  physics.set_command({0.0, 0.8});
  double farthest = 0.0;
  for (int i = 0; i < static_cast<int>(500 * 2.0 * std::numbers::pi / 0.8); ++i) {
    physics.step();
    farthest = std::max(farthest, to_planar(physics.state().T_map_base).position().norm());
  }
  return farthest;
}

TEST(SkidSteer, TheIdealTrackByHand) {
  RobotModel robot = mule();
  EXPECT_NEAR(ideal_skid_track(robot), 0.4 * (1.0 + 0.75 * 0.75), 1e-9);
}

TEST(SkidSteer, PhysicsComesNearTheIdealTrack) {
  RobotModel robot = mule();
  for (const double length : {0.1, 0.2, 0.3, 0.4}) {
    for (DriveWheel& wheel : robot.wheels) {
      wheel.p_base_wheel.x() = std::copysign(0.5 * length, wheel.p_base_wheel.x());
    }
    robot.track = ideal_skid_track(robot);
    EXPECT_NEAR(measure_skid_turn(robot).track / robot.track, 1.0, 0.05) << length;
  }
}

TEST(SkidSteer, TurnsBetweenItsWheelsWhereTheyCarryAlike) {
  EXPECT_EQ(measure_skid_turn(mule()).axle_y, 0.0);
  EXPECT_EQ(mule().p_base_axle.y(), 0.0);
}

/// Turning by dry friction alone: the centre of rotation, as the distance to the left of the
/// robot's centre, and the ratio of its rate to the commanded one, at which the longitudinal force
/// and the moment vanish. `carried` [m]: distance of the centre of mass to the left. Newton's
/// method on the longitudinal speed and the rate.
Eigen::Vector2d friction_turn(const RobotModel& robot, double carried) {
  const auto missing = [&](const Eigen::Vector2d& v) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const DriveWheel& wheel : robot.wheels) {
      const Eigen::Vector2d p = wheel.p_base_wheel.head<2>();
      const double side = std::copysign(1.0, p.y());
      const double load = 0.5 + side * carried / robot.wheel_separation;
      const Eigen::Vector2d slip(v.x() - v.y() * p.y() + 0.5 * side * robot.track, v.y() * p.x());
      const Eigen::Vector2d force = -load * slip.normalized();
      sum += Eigen::Vector2d(force.x(), p.x() * force.y() - p.y() * force.x());
    }
    return sum;
  };
  Eigen::Vector2d v(0.0, 0.8);
  for (int i = 0; i < 200; ++i) {
    constexpr double kSmall = 1e-7;
    Eigen::Matrix2d slope;
    slope << (missing(v + Eigen::Vector2d(kSmall, 0.0)) - missing(v)) / kSmall,
        (missing(v + Eigen::Vector2d(0.0, kSmall)) - missing(v)) / kSmall;
    v -= 0.5 * slope.inverse() * missing(v);
  }
  return {v.x() / v.y(), v.y()};
}

TEST(SkidSteer, TurnsWhereDryFrictionSays) {
  constexpr double kHeavyWheel = 3.0;  // [kg] Light wheels get mass from the chassis.
  RobotModel robot = mule();
  for (DriveWheel& wheel : robot.wheels) wheel.mass = kHeavyWheel;
  for (const double p_y : {-0.03, -0.08, 0.06}) {
    robot.p_base_com.y() = p_y;
    const double carried = p_y * robot.chassis_mass / (robot.chassis_mass + 4.0 * kHeavyWheel);
    const Eigen::Vector2d turn = friction_turn(robot, carried);
    const SkidTurn measured = measure_skid_turn(robot);
    EXPECT_NEAR(measured.axle_y, turn.x(), 0.005) << p_y;
    EXPECT_NEAR(robot.track / measured.track, turn.y(), 0.02) << p_y;
  }
}

TEST(SkidSteer, TurnsAboutBaseAlsoWhereOneSideCarriesMore) {
  RobotModel robot = mule();
  robot.p_base_com.y() = -0.08;
  const double before = moved_by_a_turn(robot);
  steer_by_skidding(robot);
  EXPECT_LT(moved_by_a_turn(robot), 0.03);
  EXPECT_GT(before, 2.0 * moved_by_a_turn(robot));
}

TEST(SkidSteer, HasMotorsForHeavyWheelsWhereNoneAreGiven) {
  RobotModel robot = mule();
  for (DriveWheel& wheel : robot.wheels) {
    wheel.mass = 3.6;
    wheel.effort_max = 0.0;
  }
  EXPECT_NEAR(measure_skid_turn(robot).track / ideal_skid_track(robot), 1.0, 0.02);
  EXPECT_LT(moved_by_a_turn(robot), 0.03);
}

TEST(SkidSteer, LiftsLimitsThatForbidTurning) {
  RobotModel robot = mule();
  for (DriveWheel& wheel : robot.wheels) wheel.effort_max = 1.0;
  remove_low_effort_limits(robot);
  ASSERT_EQ(robot.warnings.size(), 1U);
  EXPECT_EQ(robot.wheels[0].effort_max, 0.0);
  remove_low_effort_limits(robot);
  EXPECT_EQ(robot.warnings.size(), 1U);
}

}  // namespace
}  // namespace castaway::sim
