#include "sim/people/bodies/person_visuals.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/people/gait.hpp"

namespace castaway::sim {
namespace {

TEST(PersonVisuals, StandOnTheFloorAsTallAsTheBody) {
  PersonState state;
  state.position = {3.0, -1.0};
  state.heading = 0.5;
  stand(state);
  Eigen::AlignedBox3f box;
  for (const SceneItem& item : person_visuals({}, state, 0)) {
    for (const Eigen::Vector3f& v : item.mesh.vertices) {
      box.extend(Eigen::Vector3f(item.T_map_mesh * v));
    }
  }
  EXPECT_NEAR(box.min().z(), 0.0, 1e-5);
  EXPECT_NEAR(box.max().z(), 1.75, 0.03);
  EXPECT_NEAR(box.center().x(), 3.0, 0.1);
  EXPECT_NEAR(box.center().y(), -1.0, 0.1);
  EXPECT_LT(box.sizes().x(), 0.6);
}

TEST(PersonVisuals, DressPeopleDifferently) {
  const PersonState state;
  const auto a = person_visuals({}, state, 0);
  const auto b = person_visuals({}, state, 1);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_FALSE(std::equal(a.begin(), a.end(), b.begin(),
                          [](const auto& x, const auto& y) { return x.color == y.color; }));
}

}  // namespace
}  // namespace castaway::sim
