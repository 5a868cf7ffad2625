#include "tests/bench/workbench/physics_bench.hpp"

#include <chrono>
#include <cmath>

#include "sim/robot/bodies/robot_physics.hpp"
#include "sim/stages/drive_setup.hpp"

namespace castaway::testbed {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kSlope = 5.0 * kDegree;
constexpr double kSlopeLength = 8.0;  // [m] Length of the ramp's base.

sim::WorldSpec floor_with_slope() {
  sim::WorldSpec world;
  world.min_corner = {-10.0, -10.0};
  world.max_corner = {20.0, 10.0};
  const double height = kSlopeLength * std::tan(kSlope);
  sim::WorldObject ramp;
  ramp.name = "slope";
  ramp.shape = sim::RampShape{{kSlopeLength, 4.0, height}};
  ramp.T_map_object = Eigen::Translation3d(10.0, 0.0, 0.5 * height);
  ramp.drivable = true;
  world.objects = {ramp};
  return world;
}

/// A robot that executes velocity commands and measures its motion.
class Course {
 public:
  Course(const sim::RobotModel& robot, const sim::Pose2& start, double hz)
      : hz_(hz),
        limits_(sim::limits_of(sim::DriveConfig{}, robot)),
        physics_(floor_with_slope(), robot, start, limits_,
                 std::chrono::nanoseconds(std::llround(1e9 / hz))) {
    drive({}, 1.0);  // Lets the robot settle.
  }

  void drive(const sim::Twist2& command, double seconds) {
    physics_.set_command(command);
    const int steps = static_cast<int>(std::lround(seconds * hz_));
    for (int i = 0; i < steps; ++i) {
      const double before = pose().yaw;
      physics_.step();
      turned_ += sim::wrap_angle(pose().yaw - before);
    }
  }
  [[nodiscard]] const sim::TwistLimits& limits() const { return limits_; }
  [[nodiscard]] Eigen::Isometry3d T_map_base() const { return physics_.state().T_map_base; }
  [[nodiscard]] sim::Pose2 pose() const { return sim::to_planar(T_map_base()); }
  [[nodiscard]] Eigen::Vector3d p() const { return T_map_base().translation(); }
  /// [rad] Sum of all rotations since the start.
  [[nodiscard]] double turned() const { return turned_; }

 private:
  double hz_;
  sim::TwistLimits limits_;
  sim::RobotPhysics physics_;
  double turned_ = 0.0;
};

/// Radius of the circle through three points.
double radius_through(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                      const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  const double twice_area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  return ab.norm() * ac.norm() * (c - b).norm() / (2.0 * twice_area);
}

void check_straight(const sim::RobotModel& robot, double hz, std::vector<PhysicsCheck>& checks) {
  Course course(robot, {-8.0, 0.0, 0.0}, hz);
  const double v = course.limits().max_speed;
  const double ramp = 0.5 * v * v / course.limits().max_acceleration;
  const Eigen::Vector3d start = course.p();
  course.drive({v, 0.0}, 10.0);
  const Eigen::Vector3d rolling = course.p();
  checks.push_back(
      {"straight line from rest, 10 s", "m", 10.0 * v - ramp, rolling.x() - start.x()});
  checks.push_back({"  off the line", "m", 0.0, rolling.y() - start.y()});
  course.drive({0.0, 0.0}, 3.0);
  checks.push_back({"stop from full speed", "m", ramp, course.p().x() - rolling.x()});
}

void check_turn(const sim::RobotModel& robot, double hz, std::vector<PhysicsCheck>& checks) {
  Course course(robot, {}, hz);
  const Eigen::Vector3d start = course.p();
  const double w = course.limits().max_turn_rate;
  course.drive({0.0, w}, 10.0);
  const double expected = 10.0 * w - 0.5 * w * w / course.limits().max_turn_acceleration;
  checks.push_back({"turn in place from rest, 10 s", "rad", expected, course.turned()});
  course.drive({0.0, 0.0}, 2.0);
  const Eigen::Vector3d axle(robot.p_base_axle.x(), robot.p_base_axle.y(), 0.0);
  const Eigen::Vector3d before = start + axle;
  const Eigen::Vector3d after = course.T_map_base() * axle;
  checks.push_back({"  way of the axle's middle", "m", 0.0, (after - before).head<2>().norm()});
}

void check_arc(const sim::RobotModel& robot, double hz, std::vector<PhysicsCheck>& checks) {
  Course course(robot, {}, hz);
  const Eigen::Vector3d axle(robot.p_base_axle.x(), robot.p_base_axle.y(), 0.0);
  const auto at = [&]() -> Eigen::Vector2d { return (course.T_map_base() * axle).head<2>(); };
  const sim::Twist2 twist{course.limits().max_speed, course.limits().max_speed};
  course.drive(twist, 3.0);
  const Eigen::Vector2d a = at();
  course.drive(twist, 3.0);
  const Eigen::Vector2d b = at();
  course.drive(twist, 3.0);
  checks.push_back({"radius of an arc at full speed", "m", 1.0, radius_through(a, b, at())});
}

void check_slope(const sim::RobotModel& robot, double hz, std::vector<PhysicsCheck>& checks) {
  Course course(robot, {4.5, 0.0, 0.0}, hz);
  const double v = course.limits().max_speed;
  course.drive({v, 0.0}, 4.0 / v);
  const Eigen::Vector3d a = course.p();
  course.drive({v, 0.0}, 4.0);
  const Eigen::Vector3d b = course.p();
  const Eigen::Vector3d x_base = course.T_map_base().linear().col(0);
  checks.push_back({"speed up a slope of 5 degrees", "m/s", v, (b - a).norm() / 4.0});
  checks.push_back({"  pitch on it", "deg", 5.0, std::asin(x_base.z()) / kDegree});
  course.drive({0.0, 0.0}, 3.0);
  const Eigen::Vector3d held = course.p();
  course.drive({0.0, 0.0}, 10.0);
  checks.push_back({"  creep while it holds, 10 s", "m", 0.0, (course.p() - held).norm()});
}

}  // namespace

std::vector<PhysicsCheck> check_physics(const sim::RobotModel& robot, double physics_hz) {
  std::vector<PhysicsCheck> checks;
  check_straight(robot, physics_hz, checks);
  check_turn(robot, physics_hz, checks);
  check_arc(robot, physics_hz, checks);
  check_slope(robot, physics_hz, checks);
  return checks;
}

}  // namespace castaway::testbed
