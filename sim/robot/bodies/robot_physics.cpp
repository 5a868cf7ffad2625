#include "sim/robot/bodies/robot_physics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/common/seconds.hpp"
#include "sim/robot/bodies/robot_shapes.hpp"
#include "sim/robot/bodies/wheel_body.hpp"
#include "sim/world/bullet_types.hpp"
#include "sim/world/physics_world.hpp"

namespace castaway::sim {
namespace {

constexpr double kPhysicsGap = 0.5;  // [s] Contacts closer in time are one collision.

Eigen::Isometry3d at(const Eigen::Vector3d& p) {
  return Eigen::Isometry3d(Eigen::Translation3d(p));
}

}  // namespace

struct RobotPhysics::Body {
  Body(const WorldSpec& spec, RobotModel model, const TwistLimits& twist_limits, double dt);
  ~Body();
  void place(btRigidBody& body, const Eigen::Isometry3d& T_map_body);
  void place_all(const Eigen::Isometry3d& T_map_base);
  [[nodiscard]] bool is_left(const WheelBody& wheel) const;
  void drive();
  void turn_wheels(HeldWheels held);
  void read_state();
  void count_collisions();

  RobotModel robot;
  TwistLimits limits;
  double time_step;
  PhysicsWorld world;
  ChassisShape shape;
  std::unique_ptr<btRigidBody> chassis;
  std::vector<WheelBody> wheels;
  Twist2 command;
  Twist2 twist;
  RobotState state;
  std::int64_t collisions = 0;
  double contact_age = kPhysicsGap;
};

RobotPhysics::Body::Body(const WorldSpec& spec, RobotModel model, const TwistLimits& twist_limits,
                         double dt)
    : robot(std::move(model)), limits(twist_limits), time_step(dt), world(spec, dt), shape(robot) {
  const Eigen::Vector3d inertia = robot.inertia.diagonal();
  chassis = make_body(chassis_body_mass(robot), to_bullet(inertia), shape.compound(), 0.0);
  const int everything_else = kGroundGroup | kObstacleGroup;
  world.bullet().addRigidBody(chassis.get(), kRobotGroup, everything_else);
  for (const DriveWheel& wheel : robot.wheels) wheels.emplace_back(wheel, robot, *chassis);
  for (WheelBody& wheel : wheels) {
    world.bullet().addRigidBody(&wheel.body(), kRobotGroup, kGroundGroup);
    world.bullet().addConstraint(&wheel.hinge(), true);
  }
}

RobotPhysics::Body::~Body() {
  for (WheelBody& wheel : wheels) {
    world.bullet().removeConstraint(&wheel.hinge());
    world.bullet().removeRigidBody(&wheel.body());
  }
  world.bullet().removeRigidBody(chassis.get());
}

void RobotPhysics::Body::place(btRigidBody& body, const Eigen::Isometry3d& T_map_body) {
  body.setWorldTransform(to_bullet(T_map_body));
  body.setInterpolationWorldTransform(to_bullet(T_map_body));
  body.setLinearVelocity(btVector3(0.0, 0.0, 0.0));
  body.setAngularVelocity(btVector3(0.0, 0.0, 0.0));
  body.setInterpolationLinearVelocity(btVector3(0.0, 0.0, 0.0));
  body.setInterpolationAngularVelocity(btVector3(0.0, 0.0, 0.0));
  body.clearForces();
  body.updateInertiaTensor();
  auto& bullet = world.bullet();
  if (body.getBroadphaseHandle() == nullptr) return;
  bullet.getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(body.getBroadphaseHandle(),
                                                                         bullet.getDispatcher());
  bullet.updateSingleAabb(&body);
}

void RobotPhysics::Body::place_all(const Eigen::Isometry3d& T_map_base) {
  place(*chassis, T_map_base * at(robot.p_base_com));
  for (WheelBody& wheel : wheels) {
    wheel.rest();
    const Eigen::Isometry3d T_base_wheel =
        at(wheel.model().p_base_wheel) * Eigen::AngleAxisd(wheel.angle(), Eigen::Vector3d::UnitY());
    place(wheel.body(), T_map_base * T_base_wheel);
  }
}

void RobotPhysics::Body::turn_wheels(HeldWheels held) {
  twist = held_twist(held, twist, ramp_twist(twist, command, limits, time_step), time_step);
  const Twist2 axle = axle_twist(twist, robot.p_base_axle);
  for (WheelBody& wheel : wheels) {
    const double side = is_left(wheel) ? -0.5 : 0.5;
    wheel.turn((axle.v + side * robot.track * axle.w) / wheel.model().radius * time_step);
  }
}

bool RobotPhysics::Body::is_left(const WheelBody& wheel) const {
  return wheel.model().p_base_wheel.y() > robot.p_base_axle.y();
}

/// Where a wheel would turn too fast, both sides slow down by the same factor, so that the curve
/// stays the same.
void RobotPhysics::Body::drive() {
  twist = ramp_twist(twist, command, limits, time_step);
  const Twist2 axle = axle_twist(twist, robot.p_base_axle);
  const double left = axle.v - 0.5 * robot.track * axle.w;
  const double right = axle.v + 0.5 * robot.track * axle.w;
  double share = 1.0;
  for (const WheelBody& wheel : wheels) {
    const double limit = wheel.model().speed_max * wheel.model().radius;
    const double fastest = std::max(std::abs(left), std::abs(right));
    if (limit > 0.0 && fastest > limit) share = std::min(share, limit / fastest);
  }
  for (WheelBody& wheel : wheels) {
    const double speed = share * (is_left(wheel) ? left : right) / wheel.model().radius;
    wheel.drive(speed, time_step);
  }
}

void RobotPhysics::Body::read_state() {
  state.T_map_base = to_eigen(chassis->getWorldTransform()) * at(-robot.p_base_com);
  state.wheels = {};
  for (WheelBody& wheel : wheels) {
    wheel.read_angle();
    const double share = 2.0 / static_cast<double>(wheels.size());
    (is_left(wheel) ? state.wheels.left : state.wheels.right) += share * wheel.angle();
  }
}

void RobotPhysics::Body::count_collisions() {
  auto& dispatcher = *world.bullet().getDispatcher();
  bool touching = false;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    const bool floor = manifold.getBody0()->getUserIndex() == kFloorIndex ||
                       manifold.getBody1()->getUserIndex() == kFloorIndex;
    for (int p = 0; p < manifold.getNumContacts() && !floor; ++p) {
      touching = touching || manifold.getContactPoint(p).getDistance() <= 0.0;
    }
  }
  if (touching && contact_age >= kPhysicsGap) ++collisions;
  contact_age = touching ? 0.0 : contact_age + time_step;
}

RobotPhysics::RobotPhysics(const WorldSpec& world, const RobotModel& robot, const Pose2& start,
                           const TwistLimits& limits, std::chrono::nanoseconds time_step)
    : body_(std::make_unique<Body>(world, robot, limits, to_seconds(time_step))) {
  teleport(start);
}

RobotPhysics::RobotPhysics(RobotPhysics&&) noexcept = default;
RobotPhysics& RobotPhysics::operator=(RobotPhysics&&) noexcept = default;
RobotPhysics::~RobotPhysics() = default;

void RobotPhysics::set_command(const Twist2& command) { body_->command = command; }

void RobotPhysics::set_objects(const WorldSpec& world) { body_->world.set_objects(world); }

void RobotPhysics::step() {
  body_->drive();
  body_->world.step();
  body_->read_state();
  body_->count_collisions();
}

void RobotPhysics::step_held(const Eigen::Isometry3d& T_map_base, HeldWheels wheels) {
  body_->turn_wheels(wheels);
  body_->place_all(T_map_base);
  body_->read_state();
}

void RobotPhysics::teleport(const Pose2& T_map_base) { place(to_isometry(T_map_base)); }

void RobotPhysics::place(const Eigen::Isometry3d& T_map_base) {
  body_->twist = {};
  body_->place_all(T_map_base);
  body_->read_state();
}

const RobotState& RobotPhysics::state() const { return body_->state; }

std::int64_t RobotPhysics::collisions() const { return body_->collisions; }

bool RobotPhysics::touching() const { return body_->contact_age == 0.0; }

}  // namespace castaway::sim
