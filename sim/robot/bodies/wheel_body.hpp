/// Driven wheels as Bullet sees them. Internal to sim/robot.
#pragma once

#include <memory>

#include <btBulletDynamicsCommon.h>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// A body that never sleeps. `inertia`: its diagonal.
std::unique_ptr<btRigidBody> make_body(double mass, const btVector3& inertia,
                                       btCollisionShape* shape, double friction);

/// Mass of the chassis' body. The solver does not converge where light wheels carry a heavy
/// chassis, and the robot drifts by decimetres: wheels take over some of the chassis' mass. The
/// whole weighs what it should. [kg]
double chassis_body_mass(const RobotModel& robot);

/// A ball on a hinge with a speed controller.
class WheelBody {
 public:
  /// `model` and `chassis` must outlive the wheel.
  WheelBody(const DriveWheel& model, const RobotModel& robot, btRigidBody& chassis);

  /// Turns at `speed` [rad/s] from the next step of `dt` [s] on, as far as the motor's torque goes.
  void drive(double speed, double dt);
  /// Turns by an angle [rad] outside of physics: the robot is held.
  void turn(double angle) { angle_ += angle; }
  /// Reads the angle after a step.
  void read_angle();
  /// Forgets what the controller still had to catch up with.
  void rest() { lag_ = 0.0; }

  [[nodiscard]] const DriveWheel& model() const { return *model_; }
  [[nodiscard]] btRigidBody& body() { return *body_; }
  [[nodiscard]] btHingeConstraint& hinge() { return *hinge_; }
  /// Angle about base's y since the start, unwrapped. [rad]
  [[nodiscard]] double angle() const { return angle_; }

 private:
  const DriveWheel* model_;
  const btRigidBody* chassis_;
  double effort_;
  std::unique_ptr<btSphereShape> shape_;
  std::unique_ptr<btRigidBody> body_;
  std::unique_ptr<btHingeConstraint> hinge_;
  double angle_ = 0.0;
  double lag_ = 0.0;  ///< [rad] Of the angle behind the commanded one: the controller's integral.
};

}  // namespace castaway::sim
