/// Contacts of balls with boxes in closed form, where Bullet searches for them. Internal to
/// sim/world.
#pragma once

#include <btBulletCollisionCommon.h>

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

namespace castaway::sim {

/// Where a ball and a box are nearest to each other, in the box's frame.
struct BallBoxGap {
  btVector3 p_box;   ///< [m] Point on the box.
  btVector3 normal;  ///< Unit vector from the box to the ball.
  btScalar length;   ///< [m] From the box to the ball; negative if they overlap.
};

/// `center`: of the ball, in the box's frame [m].
BallBoxGap ball_box_gap(const btVector3& center, btScalar radius, const btVector3& half_extents);

/// Bullet's algorithm for a pair of a ball and a box, in either order. A pair has one contact, as
/// with Bullet's own algorithm, which searches for it (GJK).
class BallBoxContact final : public btActivatingCollisionAlgorithm {
 public:
  BallBoxContact(btPersistentManifold* manifold, const btCollisionAlgorithmConstructionInfo& info,
                 const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                 bool ball_first);
  ~BallBoxContact() override;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& dispatch, btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject* a, btCollisionObject* b,
                                 const btDispatcherInfo& dispatch,
                                 btManifoldResult* result) override;
  void getAllContactManifolds(btManifoldArray& manifolds) override;

 private:
  btPersistentManifold* manifold_;
  bool owns_manifold_ = false;
  bool ball_first_;
};

/// Makes them for Bullet.
struct BallBoxContacts final : public btCollisionAlgorithmCreateFunc {
  explicit BallBoxContacts(bool ball_first) { m_swapped = !ball_first; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* a,
                                                 const btCollisionObjectWrapper* b) override;
};

/// Bullet's configuration with these contacts.
class BallBoxConfiguration final : public btDefaultCollisionConfiguration {
 public:
  using btDefaultCollisionConfiguration::btDefaultCollisionConfiguration;

  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int a, int b) override;

 private:
  BallBoxContacts ball_box_{true};
  BallBoxContacts box_ball_{false};
};

}  // namespace castaway::sim
