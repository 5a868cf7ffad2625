#include "sim/people/forces/mutual_forces.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/common/random.hpp"

namespace castaway::sim {
namespace {

const SocialForceConfig kMutualConfig;

Crowding throng(int count, double edge, unsigned seed) {
  Rng rng(seed);
  const auto draw = [&rng](double most) { return draw_between(-most, most, rng); };
  Crowding people;
  for (int i = 0; i < count; ++i) {
    const double x = draw(0.5 * edge);
    people.positions.emplace_back(x, draw(0.5 * edge));
    const double vx = draw(1.3);
    people.velocities.emplace_back(vx, draw(1.3));
  }
  return people;
}

TEST(MutualForces, OfTwoAreOpposite) {
  const Crowding two{{{0.0, 0.0}, {1.5, 0.4}}, {{1.0, 0.0}, {-1.0, 0.2}}};
  const auto forces = mutual_forces(kMutualConfig, two);
  EXPECT_EQ(forces[0], social_force(kMutualConfig, {1.5, 0.4}, {2.0, -0.2}));
  EXPECT_EQ(forces[1], -forces[0]);
}

TEST(MutualForces, OfFewAreThoseOfPairsToTheBit) {
  const Crowding people = throng(static_cast<int>(kFewPeople), 6.0, 1);
  EXPECT_EQ(mutual_forces(kMutualConfig, people), forces_of_pairs(kMutualConfig, people));
}

/// The bound: a force that rounding moves across the cut-off is at most A sqrt(2) exp(-6) = 0.0074.
TEST(MutualForces, OfNeighboursDifferFromAllPairsByLessThanTheCutOff) {
  for (const double edge : {10.0, 40.0}) {
    const Crowding people = throng(200, edge, 2);
    const auto exact = forces_of_pairs(kMutualConfig, people);
    const auto forces = forces_of_neighbours(kMutualConfig, people);
    double squares = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_LT((forces[i] - exact[i]).norm(), 0.0075) << i;
      squares += (forces[i] - exact[i]).squaredNorm();
    }
    EXPECT_LT(std::sqrt(squares / 200.0), 1e-3);
  }
}

/// Moving everybody elsewhere changes nothing but rounding.
TEST(MutualForces, OfNeighboursDoNotDependOnTheOrigin) {
  Crowding people = throng(100, 12.0, 3);
  const auto here = forces_of_neighbours(kMutualConfig, people);
  for (Eigen::Vector2d& p : people.positions) p += Eigen::Vector2d(4096.0, -512.0);
  const auto there = forces_of_neighbours(kMutualConfig, people);
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_LT((there[i] - here[i]).norm(), 0.0075);
}

TEST(MutualForces, OfNobodyAreNone) {
  EXPECT_TRUE(mutual_forces(kMutualConfig, {}).empty());
  EXPECT_TRUE(forces_of_neighbours(kMutualConfig, {}).empty());
}

}  // namespace
}  // namespace castaway::sim
