#include "sim/people/forces/packed_force.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/common/random.hpp"

namespace castaway::sim {
namespace {

const SocialForceConfig kPackedConfig;

TEST(PackedForces, AreTheFormulaByHandForSomebodyAtRest) {
  PackedPeople others;
  others.push_back({1.0F, 0.0F, 0.0F, 0.0F});
  PackedForces forces;
  packed_forces(kPackedConfig, {}, others, forces);
  const double strength = 2.1 * std::exp(-1.0 / 0.35);
  EXPECT_NEAR(forces.x[0], -strength, 1e-5);
  EXPECT_NEAR(forces.y[0], -strength, 1e-5);
}

TEST(PackedForces, EndAtTheCutOffs) {
  PackedPeople others;
  others.push_back({0.0F, 0.0F, 1.0F, 0.0F});    // In the same place.
  others.push_back({5.01F, 0.0F, -3.0F, 0.0F});  // Beyond the reach.
  others.push_back({2.11F, 0.0F, 0.0F, 0.0F});   // d / B = 6.03.
  others.push_back({4.99F, 0.0F, -3.0F, 0.0F});
  std::vector<float> margins;
  cut_off(kPackedConfig, {}, others, 0, 4, margins);
  EXPECT_LT(margins[1], 0.0F);
  EXPECT_LT(margins[2], 0.0F);
  EXPECT_GT(margins[3], 0.0F);
  PackedForces forces;
  packed_forces(kPackedConfig, {}, others, forces);
  EXPECT_EQ(forces.x[0], 0.0F);
  EXPECT_EQ(forces.x[2], 0.0F);
  EXPECT_LT(forces.x[3], 0.0F);
}

/// Where the exact exponent is within rounding of the cut-off, either side is right.
TEST(PackedForces, AreSocialForceWithinAThousandth) {
  Rng rng(3);
  const auto draw = [&rng](double most) { return draw_between(-most, most, rng); };
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2d offset(draw(5.0), draw(5.0));
    const Eigen::Vector2d approach(draw(3.0), draw(3.0));
    const Eigen::Vector2d exact = social_force(kPackedConfig, offset, approach);
    PackedPeople others;
    others.push_back({static_cast<float>(offset.x()), static_cast<float>(offset.y()),
                      static_cast<float>(-approach.x()), static_cast<float>(-approach.y())});
    PackedForces forces;
    packed_forces(kPackedConfig, {}, others, forces);
    std::vector<float> margins;
    cut_off(kPackedConfig, {}, others, 0, 1, margins);
    if (exact.norm() > 0.0) {
      EXPECT_GE(margins[0], 0.0F);
      ++compared;
    }
    if (margins[0] < 0.0F) continue;
    const double error = (Eigen::Vector2d(forces.x[0], forces.y[0]) - exact).norm();
    EXPECT_LT(error, 1e-3) << offset.transpose() << ", " << approach.transpose();
  }
  EXPECT_GT(compared, 2000);
}

TEST(PackedPeople, GatherTakesThoseOfTheIndices) {
  PackedPeople from;
  for (const float x : {1.0F, 2.0F, 3.0F}) from.push_back({x, 2.0F * x, 3.0F * x, 4.0F * x});
  PackedPeople people;
  people.gather(from, {2, 0});
  ASSERT_EQ(people.size(), 2U);
  EXPECT_EQ(people[0].x, 3.0F);
  EXPECT_EQ(people[1].vy, 4.0F);
}

}  // namespace
}  // namespace castaway::sim
