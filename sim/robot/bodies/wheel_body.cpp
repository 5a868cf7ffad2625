#include "sim/robot/bodies/wheel_body.hpp"

#include <algorithm>
#include <cmath>

#include "sim/common/geometry.hpp"
#include "sim/robot/bodies/robot_masses.hpp"
#include "sim/world/bullet_types.hpp"

namespace castaway::sim {
namespace {

constexpr double kWheelFriction = 1.0;
constexpr double kWheelShare = 0.15;  // Share of the chassis' mass that each wheel has at least.
constexpr double kLagGain = 10.0;     // [1/s] Without it a standing robot creeps by 0.2 mm/s.
constexpr double kMaxLag = 0.1;       // [rad]
// Spin inertia of skidding wheels relative to a ball's, for rotors and gears. The solver handles
// friction last, which stops the skid of a light wheel through its spin: with 1, a robot that is as
// long as wide turns half as fast as dry friction allows; with 7, within 3 %.
constexpr double kSkidSpin = 7.0;
// [m] Deflection of the tyres of four wheels under their load. With rigid wheels on a flat floor it
// is undetermined which of them carry: only three do, and the robot turns about one end.
constexpr double kTyreSag = 5e-4;

double body_mass(const DriveWheel& wheel, const RobotModel& robot) {
  return std::max(wheel.mass, kWheelShare * robot.chassis_mass);
}

/// Motor torque if the file gives none: enough for an acceleration of half a g, shared by the
/// wheels. For a skid steer, whose wheels must overcome friction to turn, three times the torque
/// that this takes with equal loads.
double effort_of(const DriveWheel& wheel, const RobotModel& robot) {
  if (wheel.effort_max > 0.0) return wheel.effort_max;
  if (robot.wheels.size() > 2) return 3.0 * wheel_load(robot) * wheel.radius;
  return 5.0 * robot.chassis_mass * wheel.radius / static_cast<double>(robot.wheels.size());
}

/// Makes a wheel's contact elastic under its share of the robot's weight, critically damped.
void soften(btRigidBody& wheel, double mass, double load) {
  const double stiffness = load / kTyreSag;
  wheel.setContactStiffnessAndDamping(stiffness, 2.0 * std::sqrt(stiffness * mass));
}

/// Rotation of `b` relative to `a` about the common y axis. [rad]
double angle_about_y(const btTransform& a, const btTransform& b) {
  const btMatrix3x3 R = a.getBasis().transposeTimes(b.getBasis());
  return std::atan2(R[0][2], R[0][0]);
}

}  // namespace

std::unique_ptr<btRigidBody> make_body(double mass, const btVector3& inertia,
                                       btCollisionShape* shape, double friction) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
  info.m_friction = friction;
  auto body = std::make_unique<btRigidBody>(info);
  body->setActivationState(DISABLE_DEACTIVATION);
  return body;
}

double chassis_body_mass(const RobotModel& robot) {
  double mass = robot.chassis_mass;
  for (const DriveWheel& wheel : robot.wheels) mass -= body_mass(wheel, robot) - wheel.mass;
  return mass;
}

WheelBody::WheelBody(const DriveWheel& model, const RobotModel& robot, btRigidBody& chassis)
    : model_(&model),
      chassis_(&chassis),
      effort_(effort_of(model, robot)),
      shape_(std::make_unique<btSphereShape>(model.radius)) {
  const double mass = body_mass(model, robot);
  const bool skids = robot.wheels.size() > 2;
  const double spin = skids ? kSkidSpin : 1.0;
  const double moment = spin * 0.4 * mass * model.radius * model.radius;
  body_ = make_body(mass, btVector3(moment, moment, moment), shape_.get(), kWheelFriction);
  if (skids) soften(*body_, mass, wheel_load(robot));
  // The hinge turns about z of its frames; rotating them by -90 degrees about x puts that on y.
  const btQuaternion z_to_y(btVector3(1.0, 0.0, 0.0), -SIMD_HALF_PI);
  const Eigen::Vector3d p_com_wheel = model.p_base_wheel - robot.p_base_com;
  hinge_ = std::make_unique<btHingeConstraint>(
      chassis, *body_, btTransform(z_to_y, to_bullet(p_com_wheel)), btTransform(z_to_y));
}

void WheelBody::drive(double speed, double dt) {
  lag_ = std::clamp(lag_ + speed * dt, -kMaxLag, kMaxLag);
  hinge_->enableAngularMotor(true, -(speed + kLagGain * lag_), effort_ * dt);
}

void WheelBody::read_angle() {
  const double now = angle_about_y(chassis_->getWorldTransform(), body_->getWorldTransform());
  const double turned = wrap_angle(now - angle_);
  angle_ += turned;
  lag_ -= turned;
}

}  // namespace castaway::sim
