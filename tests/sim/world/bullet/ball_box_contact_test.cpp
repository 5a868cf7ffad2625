#include "sim/world/bullet/ball_box_contact.hpp"

#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "sim/common/random.hpp"

namespace castaway::sim {
namespace {

constexpr double kRadius = 0.05;  // [m]
const btVector3 kHalf(0.3, 0.2, 0.1);

/// A contact as Bullet reports it: of the first body with the second one.
struct Contact {
  btVector3 on_first;
  btVector3 on_second;
  btVector3 normal;
  double distance = 0.0;
};

/// Keeps the contact of a pair.
class Listener final : public btCollisionWorld::ContactResultCallback {
 public:
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* /*a*/,
                           int /*part_a*/, int /*index_a*/, const btCollisionObjectWrapper* /*b*/,
                           int /*part_b*/, int /*index_b*/) override {
    contact = Contact{point.m_positionWorldOnA, point.m_positionWorldOnB, point.m_normalWorldOnB,
                      point.m_distance1};
    ++contacts;
    return 0.0;
  }
  std::optional<Contact> contact;
  int contacts = 0;
};

/// A ball and a box without a margin: with one, Bullet's box has round corners.
template <typename Configuration>
class Pair {
 public:
  Pair() {
    box_shape_.setMargin(0.0);
    ball_.setCollisionShape(&ball_shape_);
    box_.setCollisionShape(&box_shape_);
  }
  std::optional<Contact> contact(const btTransform& T_map_box, const btVector3& p_map_ball,
                                 bool ball_first) {
    box_.setWorldTransform(T_map_box);
    ball_.setWorldTransform(btTransform(btQuaternion::getIdentity(), p_map_ball));
    Listener listener;
    world_.contactPairTest(ball_first ? &ball_ : &box_, ball_first ? &box_ : &ball_, listener);
    EXPECT_LE(listener.contacts, 1);
    return listener.contact;
  }

 private:
  btSphereShape ball_shape_{kRadius};
  btBoxShape box_shape_{kHalf};
  btCollisionObject ball_;
  btCollisionObject box_;
  Configuration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

btVector3 drawn(double reach, Rng& rng) {
  return {draw_between(-reach, reach, rng), draw_between(-reach, reach, rng),
          draw_between(-reach, reach, rng)};
}

void expect_near(const btVector3& ours, const btVector3& bullets, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], bullets[i], tolerance);
}

/// Balls whose centre is outside of the box.
TEST(BallBoxContact, IsWhereBulletFindsIt) {
  Rng rng(3);
  Pair<BallBoxConfiguration> ours;
  Pair<btDefaultCollisionConfiguration> bullets;
  int touching = 0;
  for (int i = 0; i < 3000; ++i) {
    const btQuaternion turn(drawn(1.0, rng), draw_between(-3.0, 3.0, rng));
    const btTransform T_map_box(turn, drawn(10.0, rng));
    const btVector3 center = drawn(0.4, rng);
    if (ball_box_gap(center, 0.0, kHalf).length < 1e-3) continue;
    for (const bool ball_first : {true, false}) {
      const auto a = ours.contact(T_map_box, T_map_box * center, ball_first);
      const auto b = bullets.contact(T_map_box, T_map_box * center, ball_first);
      ASSERT_EQ(a.has_value(), b.has_value()) << i;
      if (!a) continue;
      ++touching;
      EXPECT_NEAR(a->distance, b->distance, 1e-5);
      expect_near(a->normal, b->normal, 1e-3);
      expect_near(a->on_first, b->on_first, 1e-4);
      expect_near(a->on_second, b->on_second, 1e-4);
    }
  }
  EXPECT_GT(touching, 500);
}

TEST(BallBoxContact, PushesABallThatIsInsideOutOfTheNearestFace) {
  const BallBoxGap gap = ball_box_gap(btVector3(0.1, -0.17, 0.02), kRadius, kHalf);
  EXPECT_EQ(gap.normal, btVector3(0.0, -1.0, 0.0));
  EXPECT_EQ(gap.p_box, btVector3(0.1, -0.2, 0.02));
  EXPECT_NEAR(gap.length, -0.03 - kRadius, 1e-12);
}

TEST(BallBoxContact, OfABallAtTheCentreHasADirection) {
  const BallBoxGap gap = ball_box_gap(btVector3(0.0, 0.0, 0.0), kRadius, kHalf);
  EXPECT_EQ(gap.normal, btVector3(0.0, 0.0, 1.0));
  EXPECT_NEAR(gap.length, -0.1 - kRadius, 1e-12);
}

/// Height of a ball's centre after it fell on a slab, alone or as a part of a body.
double resting_height(bool compound) {
  BallBoxConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0.0, 0.0, -9.81));
  btBoxShape slab(btVector3(5.0, 5.0, 0.5));
  btSphereShape ball(kRadius);
  btCompoundShape part;
  part.addChildShape(btTransform::getIdentity(), &ball);
  btRigidBody ground(0.0, nullptr, &slab);
  btCollisionShape* falling = &ball;
  if (compound) falling = &part;
  btRigidBody body(1.0, nullptr, falling, btVector3(0.001, 0.001, 0.001));
  body.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0.2, 0.1, 0.7)));
  world.addRigidBody(&ground);
  world.addRigidBody(&body);
  for (int i = 0; i < 500; ++i) world.stepSimulation(1.0 / 240.0, 0);
  const double height = body.getWorldTransform().getOrigin().z();
  world.removeRigidBody(&body);
  world.removeRigidBody(&ground);
  return height;
}

TEST(BallBoxContact, BearsABall) {
  EXPECT_NEAR(resting_height(false), 0.5 + kRadius, 1e-3);
  EXPECT_NEAR(resting_height(true), 0.5 + kRadius, 1e-3);
}

}  // namespace
}  // namespace castaway::sim
