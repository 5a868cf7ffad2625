#include "sim/world/physics_world.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "sim/common/cell_index.hpp"
#include "sim/world/bullet_types.hpp"
#include "sim/world/floor.hpp"
#include "sim/world/footprint.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/ramp.hpp"

namespace castaway::sim {
namespace {

constexpr double kFloorThickness = 1.0;  // [m]
constexpr double kFloorMargin = 20.0;    // [m] Floor beyond the world's extent.
constexpr double kFloorFriction = 1.0;
constexpr int kSolverIterations = 20;
constexpr std::size_t kManyObjects = 200;
constexpr double kTileEdge = 3.0;  // [m]

/// Pools for the contacts of one robot; Bullet allocates more if it needs them. Its own hold 4096,
/// which takes longer to make than many runs in a campaign take to begin.
btDefaultCollisionConstructionInfo few_contacts() {
  constexpr int kPool = 128;
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = kPool;
  info.m_defaultMaxCollisionAlgorithmPoolSize = kPool;
  return info;
}

/// Skips triangles on the floor, which is a separate box: casters would hit their edges.
std::unique_ptr<btTriangleMesh> triangles_of(const MeshShape& shape,
                                             const Eigen::Isometry3d& T_map_shape) {
  const TriangleMesh mesh = load_mesh(shape.path, shape.scale);
  auto triangles = std::make_unique<btTriangleMesh>();
  const auto vertex = [&mesh](std::size_t i) -> Eigen::Vector3d {
    return mesh.vertices[mesh.indices[i]].cast<double>();
  };
  const auto lies_on_floor = [&](std::size_t i) {
    return (T_map_shape * vertex(i)).z() <= kFloorTop;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    if (lies_on_floor(i) && lies_on_floor(i + 1) && lies_on_floor(i + 2)) continue;
    triangles->addTriangle(to_bullet(vertex(i)), to_bullet(vertex(i + 1)),
                           to_bullet(vertex(i + 2)));
  }
  return triangles;
}

/// True for rugs and marks on the floor.
bool is_flat(const WorldObject& object) {
  return !object.drivable && !std::holds_alternative<MeshShape>(object.shape) &&
         bounds(object).max().z() <= kFloorTop;
}

/// A hull without margin, so that wheels roll exactly on the face.
std::unique_ptr<btCollisionShape> hull_of(const RampShape& ramp) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const RampTriangle& triangle : ramp_triangles(ramp)) {
    for (const Eigen::Vector3d& p : triangle) hull->addPoint(to_bullet(p), false);
  }
  hull->optimizeConvexHull();
  hull->setMargin(0.0);
  hull->recalcLocalAabb();
  return hull;
}

}  // namespace

PhysicsWorld::PhysicsWorld(const WorldSpec& spec, double time_step)
    : time_step_(time_step),
      configuration_(few_contacts()),
      dispatcher_(&configuration_),
      world_(
          std::make_unique<OneRobotWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_)) {
  world_->setGravity(btVector3(0.0, 0.0, -kGravity));
  world_->getSolverInfo().m_numIterations = kSolverIterations;
  world_->getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  world_->setForceUpdateAllAabbs(false);  // Static objects do not move.
  add_floor(spec);
  add_objects(spec);
}

PhysicsWorld::~PhysicsWorld() {
  for (const auto& body : bodies_) world_->removeRigidBody(body.get());
}

void PhysicsWorld::set_objects(const WorldSpec& spec) {
  while (bodies_.size() > 1) {
    world_->removeRigidBody(bodies_.back().get());
    bodies_.pop_back();
  }
  shapes_.resize(1);
  meshes_.clear();
  add_objects(spec);
}

void PhysicsWorld::step() { world_->stepSimulation(time_step_, 0); }

/// Many objects are merged into one body per tile of a few square metres: a smaller tree of
/// bounding boxes.
void PhysicsWorld::add_objects(const WorldSpec& spec) {
  const bool gather = spec.objects.size() > kManyObjects;
  std::map<std::pair<int, int>, std::unique_ptr<btCompoundShape>> tiles;
  for (const WorldObject& object : spec.objects) {
    if (!object.in_world || is_flat(object)) continue;
    std::unique_ptr<btCollisionShape> shape = shape_of(object);
    if (!shape) continue;
    if (object.drivable) {  // Only wheels and casters collide with the ground group.
      add_static(std::move(shape), object.T_map_object, kGroundGroup);
      continue;
    }
    if (!gather || std::holds_alternative<MeshShape>(object.shape)) {
      add_static(std::move(shape), object.T_map_object, kObstacleGroup);
      continue;
    }
    const Eigen::Vector3d p = object.T_map_object.translation() / kTileEdge;
    auto& tile = tiles[{cell_index(p.x()), cell_index(p.y())}];
    if (!tile) tile = std::make_unique<btCompoundShape>();
    tile->addChildShape(to_bullet(object.T_map_object), shape.get());
    shapes_.push_back(std::move(shape));
  }
  for (auto& [index, tile] : tiles) {
    add_static(std::move(tile), Eigen::Isometry3d::Identity(), kObstacleGroup);
  }
}

void PhysicsWorld::add_floor(const WorldSpec& spec) {
  const Eigen::Vector2d half =
      0.5 * (spec.max_corner - spec.min_corner) + Eigen::Vector2d::Constant(kFloorMargin);
  const Eigen::Vector2d center = 0.5 * (spec.max_corner + spec.min_corner);
  Eigen::Isometry3d T_map_floor = Eigen::Isometry3d::Identity();
  T_map_floor.translation() << center.x(), center.y(), -0.5 * kFloorThickness;
  add_static(std::make_unique<btBoxShape>(btVector3(half.x(), half.y(), 0.5 * kFloorThickness)),
             T_map_floor, kGroundGroup);
}

void PhysicsWorld::add_static(std::unique_ptr<btCollisionShape> shape,
                              const Eigen::Isometry3d& T_map_shape, int group) {
  btRigidBody::btRigidBodyConstructionInfo info(0.0, nullptr, shape.get());
  info.m_startWorldTransform = to_bullet(T_map_shape);
  info.m_friction = kFloorFriction;
  auto body = std::make_unique<btRigidBody>(info);
  body->setUserIndex(group == kGroundGroup ? kFloorIndex : kObstacleIndex);
  world_->addRigidBody(body.get(), group, kRobotGroup);
  shapes_.push_back(std::move(shape));
  bodies_.push_back(std::move(body));
}

std::unique_ptr<btCollisionShape> PhysicsWorld::shape_of(const WorldObject& object) {
  const ObjectShape& shape = object.shape;
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    return std::make_unique<btBoxShape>(to_bullet(Eigen::Vector3d(0.5 * box->size)));
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    return std::make_unique<btCylinderShapeZ>(
        btVector3(cylinder->radius, cylinder->radius, 0.5 * cylinder->height));
  }
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    return std::make_unique<btSphereShape>(sphere->radius);
  }
  if (const auto* ramp = std::get_if<RampShape>(&shape)) return hull_of(*ramp);
  meshes_.push_back(triangles_of(std::get<MeshShape>(shape), object.T_map_object));
  if (meshes_.back()->getNumTriangles() == 0) return nullptr;
  return std::make_unique<btBvhTriangleMeshShape>(meshes_.back().get(), true);
}

}  // namespace castaway::sim
