#include "sim/robot/bodies/robot_masses.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double z) {
  return Eigen::Vector3d(x, y, z).asDiagonal();
}

TEST(Inertia, KnowsWhatCannotBe) {
  EXPECT_TRUE(possible_inertia(diagonal(1.0, 1.0, 1.0)));
  EXPECT_TRUE(possible_inertia(diagonal(1.0, 1.0, 2.0)));  // A thin disc.
  EXPECT_FALSE(possible_inertia(diagonal(1.0, 1.0, 2.1)));
  EXPECT_FALSE(possible_inertia(diagonal(0.0, 0.0, 0.0)));
  EXPECT_FALSE(possible_inertia(diagonal(1.0, -1.0, 1.0)));
  Eigen::Matrix3d coupled = diagonal(1.0, 1.0, 1.0);
  coupled(0, 1) = coupled(1, 0) = 1.5;
  EXPECT_FALSE(possible_inertia(coupled));
}

TEST(Inertia, OfABoxByHand) {
  const BodyMass body = box_mass({{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}}, 12.0);
  EXPECT_TRUE(body.inertia.isApprox(diagonal(13.0, 10.0, 5.0)));
  EXPECT_TRUE(body.p_base_com.isApprox(Eigen::Vector3d(0.5, 1.0, 1.5)));
}

TEST(Inertia, OfABoxIsThatOfItsHalves) {
  const BodyMass whole = box_mass({{0.0, 0.0, 0.0}, {2.0, 1.0, 0.5}}, 4.0);
  const BodyMass sum = lump({box_mass({{0.0, 0.0, 0.0}, {1.0, 1.0, 0.5}}, 2.0),
                             box_mass({{1.0, 0.0, 0.0}, {2.0, 1.0, 0.5}}, 2.0)});
  EXPECT_TRUE(sum.p_base_com.isApprox(whole.p_base_com));
  EXPECT_TRUE(sum.inertia.isApprox(whole.inertia));
  EXPECT_DOUBLE_EQ(sum.mass, 4.0);
}

}  // namespace
}  // namespace castaway::sim
