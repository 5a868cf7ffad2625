#include "sim/world/bullet/ball_box_contact.hpp"

#include <new>

namespace castaway::sim {
namespace {

/// From inside of the box: out through the nearest face.
BallBoxGap gap_from_inside(const btVector3& center, btScalar radius,
                           const btVector3& half_extents) {
  const btVector3 room = half_extents - center.absolute();
  const int axis = room.minAxis();
  btVector3 normal(0.0, 0.0, 0.0);
  normal[axis] = center[axis] < 0.0 ? -1.0 : 1.0;
  btVector3 on_face = center;
  on_face[axis] = normal[axis] * half_extents[axis];
  return {on_face, normal, -room[axis] - radius};
}

}  // namespace

BallBoxGap ball_box_gap(const btVector3& center, btScalar radius, const btVector3& half_extents) {
  btVector3 nearest = center;
  nearest.setMax(-half_extents);
  nearest.setMin(half_extents);
  const btVector3 way = center - nearest;
  const btScalar distance = way.length();
  if (!(distance > SIMD_EPSILON)) return gap_from_inside(center, radius, half_extents);
  return {nearest, way / distance, distance - radius};
}

BallBoxContact::BallBoxContact(btPersistentManifold* manifold,
                               const btCollisionAlgorithmConstructionInfo& info,
                               const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                               bool ball_first)
    : btActivatingCollisionAlgorithm(info, a, b), manifold_(manifold), ball_first_(ball_first) {
  if (manifold_ != nullptr) return;
  manifold_ = m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject());
  owns_manifold_ = true;
}

BallBoxContact::~BallBoxContact() {
  if (owns_manifold_) m_dispatcher->releaseManifold(manifold_);
}

void BallBoxContact::processCollision(const btCollisionObjectWrapper* a,
                                      const btCollisionObjectWrapper* b,
                                      const btDispatcherInfo& /*dispatch*/,
                                      btManifoldResult* result) {
  const btCollisionObjectWrapper& ball = ball_first_ ? *a : *b;
  const btCollisionObjectWrapper& box = ball_first_ ? *b : *a;
  const btTransform& T_map_box = box.getWorldTransform();
  const btVector3& p_map_ball = ball.getWorldTransform().getOrigin();
  const btScalar radius = static_cast<const btSphereShape*>(ball.getCollisionShape())->getRadius();
  const BallBoxGap gap = ball_box_gap(
      T_map_box.invXform(p_map_ball), radius,
      static_cast<const btBoxShape*>(box.getCollisionShape())->getHalfExtentsWithMargin());
  result->setPersistentManifold(manifold_);
  if (gap.length <= manifold_->getContactBreakingThreshold()) {
    // Bullet wants the point on the second body, and the normal from there to the first one.
    const btVector3 normal = T_map_box.getBasis() * gap.normal;
    const btVector3 on_box = T_map_box * gap.p_box;
    if (ball_first_) {
      result->addContactPoint(normal, on_box, gap.length);
    } else {
      result->addContactPoint(-normal, p_map_ball - radius * normal, gap.length);
    }
  }
  if (owns_manifold_) result->refreshContactPoints();
}

btScalar BallBoxContact::calculateTimeOfImpact(btCollisionObject* /*a*/, btCollisionObject* /*b*/,
                                               const btDispatcherInfo& /*dispatch*/,
                                               btManifoldResult* /*result*/) {
  return 1.0;  // Nothing moves fast enough for continuous detection.
}

void BallBoxContact::getAllContactManifolds(btManifoldArray& manifolds) {
  if (owns_manifold_) manifolds.push_back(manifold_);
}

btCollisionAlgorithm* BallBoxContacts::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
    const btCollisionObjectWrapper* b) {
  void* place = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(BallBoxContact));
  return new (place) BallBoxContact(info.m_manifold, info, a, b, !m_swapped);
}

btCollisionAlgorithmCreateFunc* BallBoxConfiguration::getCollisionAlgorithmCreateFunc(int a,
                                                                                      int b) {
  if (a == SPHERE_SHAPE_PROXYTYPE && b == BOX_SHAPE_PROXYTYPE) return &ball_box_;
  if (a == BOX_SHAPE_PROXYTYPE && b == SPHERE_SHAPE_PROXYTYPE) return &box_ball_;
  return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(a, b);
}

}  // namespace castaway::sim
