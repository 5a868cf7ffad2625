/// Driven wheels as Bullet bodies. Internal to sim/robot.
#pragma once

#include <memory>

#include <btBulletDynamicsCommon.h>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// Creates a body that never sleeps. `inertia`: its diagonal.
std::unique_ptr<btRigidBody> make_body(double mass, const btVector3& inertia,
                                       btCollisionShape* shape, double friction);

/// Mass of the chassis' body. The solver does not converge if light wheels carry a heavy chassis,
/// and the robot drifts by decimetres; so wheels take some of the chassis' mass. The total stays
/// the same. [kg]
double chassis_body_mass(const RobotModel& robot);

/// A ball on a hinge with a speed controller.
class WheelBody {
 public:
  /// `model` and `chassis` must outlive the wheel.
  WheelBody(const DriveWheel& model, const RobotModel& robot, btRigidBody& chassis);

  /// Turns at `speed` [rad/s] from the next step of `dt` [s] on, within the motor's torque.
  void drive(double speed, double dt);
  /// Turns by an angle [rad] without physics, while the robot is held.
  void turn(double angle) { angle_ += angle; }
  /// Reads the angle after a step.
  void read_angle();
  /// Resets the controller's integral.
  void rest() { lag_ = 0.0; }

  [[nodiscard]] const DriveWheel& model() const { return *model_; }
  [[nodiscard]] btRigidBody& body() { return *body_; }
  [[nodiscard]] btHingeConstraint& hinge() { return *hinge_; }
  /// Angle about base's y axis since the start, unwrapped. [rad]
  [[nodiscard]] double angle() const { return angle_; }

 private:
  const DriveWheel* model_;
  const btRigidBody* chassis_;
  double effort_;
  std::unique_ptr<btSphereShape> shape_;
  std::unique_ptr<btRigidBody> body_;
  std::unique_ptr<btHingeConstraint> hinge_;
  double angle_ = 0.0;
  double lag_ = 0.0;  ///< [rad] Lag behind the commanded angle: the controller's integral.
};

}  // namespace castaway::sim
