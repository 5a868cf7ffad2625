#include "sim/people/bodies/person_rays.hpp"

#include <gtest/gtest.h>

#include "sim/people/gait.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {
namespace {

/// A person facing x, 2 m in front of the lidar.
MovingScene facing() {
  PersonState state;
  state.position = {2.0, 0.0};
  stand(state);
  return MovingScene({person_rays({}, state, 5)});
}

std::optional<RayHit> level(const MovingScene& scene, double y, double z) {
  return scene.cast({{0.0, y, z}, {1.0, 0.0, 0.0}}, 10.0);
}

TEST(PersonRays, AreTwoLegsAtShinHeight) {
  const MovingScene scene = facing();
  EXPECT_NEAR(level(scene, 0.1, 0.2)->distance, 2.0 - 0.07, 1e-12);
  EXPECT_NEAR(level(scene, -0.1, 0.2)->distance, 2.0 - 0.07, 1e-12);
  EXPECT_FALSE(level(scene, 0.0, 0.2).has_value());  // Between the legs.
  EXPECT_EQ(level(scene, 0.1, 0.2)->object, kHitPerson + 5);
}

TEST(PersonRays, AreATorsoAboveAndAHeadOnTop) {
  const MovingScene scene = facing();
  EXPECT_NEAR(level(scene, 0.0, 1.0)->distance, 2.0 - 0.14, 1e-12);
  EXPECT_TRUE(level(scene, 0.22, 1.0).has_value());
  EXPECT_FALSE(level(scene, 0.23, 1.0).has_value());
  EXPECT_NEAR(level(scene, 0.0, 1.6)->distance, 2.0 - 0.1, 1e-12);
  EXPECT_FALSE(level(scene, 0.0, 1.76).has_value());
}

}  // namespace
}  // namespace castaway::sim
