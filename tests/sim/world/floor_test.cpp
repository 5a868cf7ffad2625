#include "sim/world/floor.hpp"

#include <gtest/gtest.h>

#include "sim/world/footprint.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

const Eigen::Vector2d kMiddle(0.0, 0.0);
const Ground kGround{};  // At height 0 and infinite.

/// A slab of 8 m x 6 m with its top at `top`.
WorldSpec slab(double top, double thickness) {
  WorldSpec world;
  world.objects.push_back(box_on_floor("slab", {8.0, 6.0, thickness}, {0.0, 0.0}));
  world.objects.back().T_map_object.translation().z() = top - 0.5 * thickness;
  world.objects.push_back(box_on_floor("wall", {0.1, 6.0, 5.0}, {4.1, 0.0}));
  return world;
}

TEST(Floor, IsTheGroundWhereNothingLiesOnIt) {
  EXPECT_EQ(floor_height(WorldSpec{}, kGround, kMiddle), 0.0);
  EXPECT_EQ(floor_height(WorldSpec{}, std::nullopt, std::nullopt), 0.0);
  EXPECT_EQ(floor_height(test_room(), kGround, Eigen::Vector2d(-3.0, 0.0)), 0.0);
  EXPECT_EQ(floor_height(test_room(), std::nullopt, std::nullopt), 0.0);
}

class SlabHeight : public testing::TestWithParam<double> {};

TEST_P(SlabHeight, IsTheFloorsWhateverItIs) {
  const WorldSpec world = slab(GetParam(), GetParam());
  EXPECT_NEAR(floor_height(world, kGround, kMiddle), GetParam(), 1e-6);
  EXPECT_NEAR(floor_height(world, std::nullopt, kMiddle), GetParam(), 1e-6);
  EXPECT_NEAR(floor_height(world, kGround, std::nullopt), GetParam(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Slabs, SlabHeight, testing::Values(0.0099, 0.011, 0.02, 0.034, 0.1, 1.5));

TEST(Floor, IsBelowTheTopOfASunkSlab) {
  EXPECT_NEAR(floor_height(slab(0.9, 3.0), kGround, kMiddle), 0.9, 1e-6);
  EXPECT_NEAR(floor_height(slab(-0.2, 0.1), std::nullopt, kMiddle), -0.2, 1e-6);
}

TEST(Floor, IsUnderATableAndUnderARoof) {
  WorldSpec world = slab(0.034, 0.034);
  world.objects.push_back(slab(0.75, 0.03).objects.front());
  world.objects.push_back(slab(3.0, 0.2).objects.front());
  EXPECT_NEAR(floor_height(world, kGround, kMiddle), 0.034, 1e-6);
  EXPECT_NEAR(floor_height(world, kGround, std::nullopt), 0.034, 1e-6);
}

TEST(Floor, IsNotTheTopOfACupboard) {
  WorldSpec world;
  world.objects.push_back(box_on_floor("cupboard", {1.2, 1.2, 1.8}, {0.0, 0.0}));
  EXPECT_EQ(floor_height(world, kGround, kMiddle), 0.0);
}

TEST(Floor, IsNotTheTopOfWhatFillsTheWorld) {
  WorldSpec world;
  world.objects.push_back(box_on_floor("block", {6.0, 6.0, 0.8}, {0.0, 0.0}));
  EXPECT_EQ(floor_height(world, kGround, std::nullopt), 0.0);  // No object rises above it.
  world.objects.push_back(box_on_floor("tower", {1.0, 1.0, 3.0}, {7.0, 0.0}));
  EXPECT_EQ(floor_height(world, kGround, std::nullopt), 0.0);  // There is enough ground.
}

TEST(Floor, IsWhereTheStartIsIfThereAreTwo) {
  WorldSpec world = slab(0.1, 0.1);
  world.objects.push_back(box_on_floor("wall", {0.1, 6.0, 2.0}, {20.0, 0.0}));
  EXPECT_NEAR(floor_height(world, kGround, kMiddle), 0.1, 1e-6);
  EXPECT_NEAR(floor_height(world, kGround, Eigen::Vector2d(15.0, 0.0)), 0.0, 1e-6);
}

TEST(Floor, EndsWhereTheGroundEnds) {
  const WorldSpec world = slab(0.1, 0.1);
  const Ground far_away{-1.0, {Eigen::Vector2d(50.0, 50.0), Eigen::Vector2d(60.0, 60.0)}};
  EXPECT_NEAR(floor_height(world, far_away, kMiddle), 0.1, 1e-6);
}

TEST(Settle, LowersTheWorldAndRemovesItsFloor) {
  WorldSpec world = slab(0.1, 0.1);
  world.objects.pop_back();
  world.objects.push_back(box_on_floor("crate", {1.0, 1.0, 0.5}, {2.0, 0.0}));
  world.objects.back().T_map_object.translation().z() += 0.1;
  world.doors.push_back({});
  settle(world, 0.1);
  ASSERT_EQ(world.objects.size(), 1U);
  EXPECT_EQ(world.objects.front().name, "crate");
  EXPECT_NEAR(bounds(world.objects.front()).min().z(), 0.0, 1e-9);
  EXPECT_NEAR(world.doors.front().T_map_hinge.translation().z(), -0.1, 1e-9);
}

}  // namespace
}  // namespace castaway::sim
