#include "sim/robot/robot_physics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/robot/robot_shapes.hpp"
#include "sim/world/bullet_types.hpp"
#include "sim/world/physics_world.hpp"

namespace castaway::sim {
namespace {

constexpr double kWheelFriction = 1.0;
constexpr double kWheelShare = 0.15;  // Of the chassis' mass, each.
constexpr double kLagGain = 10.0;     // [1/s] Without it a standing robot creeps by 0.2 mm/s.
constexpr double kMaxLag = 0.1;       // [rad]
constexpr double kContactGap = 0.5;   // [s] Contacts closer in time are one collision.

Eigen::Isometry3d at(const Eigen::Vector3d& p) {
  return Eigen::Isometry3d(Eigen::Translation3d(p));
}

/// Rotation of `b` against `a` about the common y axis. [rad]
double angle_about_y(const btTransform& a, const btTransform& b) {
  const btMatrix3x3 R = a.getBasis().transposeTimes(b.getBasis());
  return std::atan2(R[0][2], R[0][0]);
}

/// A wheel on its hinge.
struct Wheel {
  const DriveWheel* model = nullptr;
  std::unique_ptr<btSphereShape> shape;
  std::unique_ptr<btRigidBody> body;
  std::unique_ptr<btHingeConstraint> hinge;
  double angle = 0.0;  // [rad] Unwrapped.
  double lag = 0.0;    // [rad] Of the angle behind the commanded one: the controller's integral.
};

std::unique_ptr<btRigidBody> make_body(double mass, const btVector3& inertia,
                                       btCollisionShape* shape, double friction) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
  info.m_friction = friction;
  auto body = std::make_unique<btRigidBody>(info);
  body->setActivationState(DISABLE_DEACTIVATION);
  return body;
}

/// The solver does not converge where light wheels carry a heavy chassis, and the robot drifts by
/// decimetres: wheels take over some of the chassis' mass. The whole weighs what it should.
double wheel_mass(const DriveWheel& wheel, const RobotModel& robot) {
  return std::max(wheel.mass, kWheelShare * robot.chassis_mass);
}

double chassis_mass(const RobotModel& robot) {
  double mass = robot.chassis_mass;
  for (const DriveWheel& wheel : robot.wheels) mass -= wheel_mass(wheel, robot) - wheel.mass;
  return mass;
}

/// Motor torque where the file gives none: an acceleration of half a g, shared by the wheels.
double effort_of(const DriveWheel& wheel, const RobotModel& robot) {
  if (wheel.effort_max > 0.0) return wheel.effort_max;
  return 5.0 * robot.chassis_mass * wheel.radius / static_cast<double>(robot.wheels.size());
}

}  // namespace

struct RobotPhysics::Body {
  Body(const WorldSpec& spec, RobotModel model, const TwistLimits& twist_limits, double dt);
  ~Body();
  void add_wheel(const DriveWheel& wheel);
  void place(btRigidBody& body, const Eigen::Isometry3d& T_map_body);
  void place_all(const Eigen::Isometry3d& T_map_base);
  [[nodiscard]] bool is_left(const Wheel& wheel) const;
  void drive();
  void read_state();
  void count_collisions();

  RobotModel robot;
  TwistLimits limits;
  double time_step;
  PhysicsWorld world;
  ChassisShape shape;
  std::unique_ptr<btRigidBody> chassis;
  std::vector<Wheel> wheels;
  Twist2 command;
  Twist2 twist;
  RobotState state;
  std::int64_t collisions = 0;
  double contact_age = kContactGap;
};

RobotPhysics::Body::Body(const WorldSpec& spec, RobotModel model, const TwistLimits& twist_limits,
                         double dt)
    : robot(std::move(model)), limits(twist_limits), time_step(dt), world(spec, dt), shape(robot) {
  const Eigen::Vector3d inertia = robot.inertia.diagonal();
  chassis = make_body(chassis_mass(robot), to_bullet(inertia), shape.compound(), 0.0);
  const int everything_else = kGroundGroup | kObstacleGroup;
  world.bullet().addRigidBody(chassis.get(), kRobotGroup, everything_else);
  for (const DriveWheel& wheel : robot.wheels) add_wheel(wheel);
  for (Wheel& wheel : wheels) {
    world.bullet().addRigidBody(wheel.body.get(), kRobotGroup, kGroundGroup);
    world.bullet().addConstraint(wheel.hinge.get(), true);
  }
}

RobotPhysics::Body::~Body() {
  for (Wheel& wheel : wheels) {
    world.bullet().removeConstraint(wheel.hinge.get());
    world.bullet().removeRigidBody(wheel.body.get());
  }
  world.bullet().removeRigidBody(chassis.get());
}

void RobotPhysics::Body::add_wheel(const DriveWheel& model) {
  Wheel wheel;
  wheel.model = &model;
  wheel.shape = std::make_unique<btSphereShape>(model.radius);
  const double mass = wheel_mass(model, robot);
  const double moment = 0.4 * mass * model.radius * model.radius;
  wheel.body =
      make_body(mass, btVector3(moment, moment, moment), wheel.shape.get(), kWheelFriction);
  // The hinge turns about z of its frames; a rotation of -90 degrees about x puts that on y.
  const btQuaternion z_to_y(btVector3(1.0, 0.0, 0.0), -SIMD_HALF_PI);
  const Eigen::Vector3d p_com_wheel = model.p_base_wheel - robot.p_base_com;
  wheel.hinge = std::make_unique<btHingeConstraint>(
      *chassis, *wheel.body, btTransform(z_to_y, to_bullet(p_com_wheel)), btTransform(z_to_y));
  wheels.push_back(std::move(wheel));
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
  twist = {};
  place(*chassis, T_map_base * at(robot.p_base_com));
  for (Wheel& wheel : wheels) {
    wheel.lag = 0.0;
    const Eigen::Isometry3d T_base_wheel =
        at(wheel.model->p_base_wheel) * Eigen::AngleAxisd(wheel.angle, Eigen::Vector3d::UnitY());
    place(*wheel.body, T_map_base * T_base_wheel);
  }
}

bool RobotPhysics::Body::is_left(const Wheel& wheel) const {
  return wheel.model->p_base_wheel.y() > robot.p_base_axle.y();
}

/// Slows both sides alike where a wheel would turn too fast, so that the curve stays the same.
void RobotPhysics::Body::drive() {
  twist = ramped(twist, command, limits, time_step);
  const double left = twist.v - 0.5 * robot.track * twist.w;
  const double right = twist.v + 0.5 * robot.track * twist.w;
  double share = 1.0;
  for (const Wheel& wheel : wheels) {
    const double limit = wheel.model->speed_max * wheel.model->radius;
    const double fastest = std::max(std::abs(left), std::abs(right));
    if (limit > 0.0 && fastest > limit) share = std::min(share, limit / fastest);
  }
  for (Wheel& wheel : wheels) {
    const double speed = share * (is_left(wheel) ? left : right) / wheel.model->radius;
    wheel.lag = std::clamp(wheel.lag + speed * time_step, -kMaxLag, kMaxLag);
    wheel.hinge->enableAngularMotor(true, -(speed + kLagGain * wheel.lag),
                                    effort_of(*wheel.model, robot) * time_step);
  }
}

void RobotPhysics::Body::read_state() {
  state.T_map_base = to_eigen(chassis->getWorldTransform()) * at(-robot.p_base_com);
  state.wheels = {};
  for (Wheel& wheel : wheels) {
    const double now = angle_about_y(chassis->getWorldTransform(), wheel.body->getWorldTransform());
    const double turned = wrap_angle(now - wheel.angle);
    wheel.angle += turned;
    wheel.lag -= turned;
    const double share = 2.0 / static_cast<double>(wheels.size());
    (is_left(wheel) ? state.wheels.left : state.wheels.right) += share * wheel.angle;
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
  if (touching && contact_age >= kContactGap) ++collisions;
  contact_age = touching ? 0.0 : contact_age + time_step;
}

RobotPhysics::RobotPhysics(const WorldSpec& world, const RobotModel& robot, const Pose2& start,
                           const TwistLimits& limits, std::chrono::nanoseconds time_step)
    : body_(std::make_unique<Body>(world, robot, limits,
                                   std::chrono::duration<double>(time_step).count())) {
  teleport(start);
}

RobotPhysics::RobotPhysics(RobotPhysics&&) noexcept = default;
RobotPhysics& RobotPhysics::operator=(RobotPhysics&&) noexcept = default;
RobotPhysics::~RobotPhysics() = default;

void RobotPhysics::set_command(const Twist2& command) { body_->command = command; }

void RobotPhysics::step() {
  body_->drive();
  body_->world.step();
  body_->read_state();
  body_->count_collisions();
}

void RobotPhysics::teleport(const Pose2& T_map_base) {
  body_->place_all(to_isometry(T_map_base));
  body_->read_state();
}

const RobotState& RobotPhysics::state() const { return body_->state; }

std::int64_t RobotPhysics::collisions() const { return body_->collisions; }

}  // namespace castaway::sim
