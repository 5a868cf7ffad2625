/// Bullet's world, with settings that make a differential drive accurate. Internal to sim/world and
/// sim/robot: it exposes Bullet's types.
///
/// Wheels are accurate to a millimetre on 20 m only with two friction directions. An infinite
/// ground plane breaks the broadphase, so the floor is a box.
#pragma once

#include <memory>
#include <vector>

#include <btBulletDynamicsCommon.h>

#include "sim/world/bullet/ball_box_contact.hpp"
#include "sim/world/bullet/few_body_solver.hpp"
#include "sim/world/bullet/one_robot_world.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Groups that decide which bodies collide.
enum CollisionGroup : int {
  kGroundGroup = 1 << 6,
  kObstacleGroup = 1 << 7,
  kRobotGroup = 1 << 8,
};

/// User indices of static bodies.
inline constexpr int kFloorIndex = 1;
inline constexpr int kObstacleIndex = 2;

/// Owns a Bullet world with static geometry. Bodies that others add must be removed by them before
/// its destruction.
class PhysicsWorld {
 public:
  /// `time_step` [s]. @throws std::runtime_error if a mesh cannot be read.
  PhysicsWorld(const WorldSpec& spec, double time_step);
  ~PhysicsWorld();
  PhysicsWorld(const PhysicsWorld&) = delete;
  PhysicsWorld& operator=(const PhysicsWorld&) = delete;

  /// Replaces all objects; the floor stays. @throws std::runtime_error if a mesh cannot be read.
  void set_objects(const WorldSpec& spec);

  /// Advances by one time step.
  void step();
  [[nodiscard]] btDiscreteDynamicsWorld& bullet() { return *world_; }

 private:
  void add_static(std::unique_ptr<btCollisionShape> shape, const Eigen::Isometry3d& T_map_shape,
                  int group);
  void add_floor(const WorldSpec& spec);
  void add_objects(const WorldSpec& spec);
  /// Shape of an object; nullptr if all of it lies on the floor.
  std::unique_ptr<btCollisionShape> shape_of(const WorldObject& object);

  double time_step_;
  BallBoxConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  FewBodySolver solver_;
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  ///< The floor's first, as among the shapes.
  std::unique_ptr<OneRobotWorld> world_;
};

}  // namespace castaway::sim
