#include "localization/space/map3d/survey_ground.hpp"

#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::localization {
namespace {

constexpr double kSurveyVoxel = 0.1;
constexpr double kFine = 0.02;  // [m] Between samples.

/// Samples of z(x, y) over a rectangle.
void add_surface(VoxelBuilder& builder, double x0, double x1, double y0, double y1,
                 const std::function<double(double, double)>& z) {
  for (double x = x0 + kFine / 2; x < x1; x += kFine) {
    for (double y = y0 + kFine / 2; y < y1; y += kFine) builder.add({x, y, z(x, y)});
  }
}

/// A lower floor at 0, an upper one at 3 m over its part x > 5, a ramp from one to the other in the
/// lane y > 6, a wall of 0.2 m on the lower floor, and a roof at 7 m that no ramp leads to.
VoxelMap two_floors() {
  VoxelBuilder builder(kSurveyVoxel);
  add_surface(builder, -12, 10, 0, 6, [](double, double) { return 0.0; });
  add_surface(builder, -12, -10, 6, 8, [](double, double) { return 0.0; });
  add_surface(builder, 5, 10, 0, 8, [](double, double) { return 2.8; });  // Underside.
  add_surface(builder, 5, 10, 0, 8, [](double, double) { return 3.0; });
  add_surface(builder, 5, 10, 0, 6, [](double, double) { return 7.0; });
  add_surface(builder, -10, 5, 6, 8, [](double x, double) { return 0.2 * (x + 10); });
  for (double z = 0.0; z < 1.2; z += kFine) {
    add_surface(builder, 1, 1.2, 2, 4, [z](double, double) { return z; });
  }
  return builder.build();
}

const ElevationMap& ground() {
  static const ElevationMap kGround = survey_ground(two_floors(), GroundConfig{});
  return kGround;
}

TEST(SurveyGround, FindsFloorsAboveEachOther) {
  EXPECT_NO_THROW(validate(ground()));
  ASSERT_EQ(ground().levels.size(), 2U);
  EXPECT_NEAR(ground().levels[0], 0.0, 0.003);
  EXPECT_NEAR(ground().levels[1], 3.0, 0.003);
  const GroundSurface* lower = surface_near(ground(), {7.05, 3.05}, 0.0);
  ASSERT_NE(lower, nullptr);
  EXPECT_TRUE(lower->drivable);
  EXPECT_EQ(lower->level, 0);
  EXPECT_NEAR(lower->clearance, 2.8, 0.01);
  const GroundSurface* upper = surface_near(ground(), {7.05, 3.05}, 3.0);
  EXPECT_EQ(upper->level, 1);
  EXPECT_NEAR(upper->clearance, 4.0, 0.01);
  const GroundSurface* roof = surface_near(ground(), {7.05, 3.05}, 7.0);
  EXPECT_FALSE(roof->drivable);
  EXPECT_TRUE(std::isinf(roof->clearance));
}

TEST(SurveyGround, ARampHasItsHeightAndSlope) {
  for (double x = -9.5; x < 4.5; x += 0.237) {
    const GroundSurface* ramp = surface_near(ground(), {x, 7.0}, 0.2 * (x + 10));
    ASSERT_NE(ramp, nullptr) << x;
    EXPECT_TRUE(ramp->drivable) << x;
    EXPECT_NEAR(ramp->slope_x, 0.2, 0.02) << x;
    EXPECT_NEAR(ramp->slope_y, 0.0, 0.01) << x;
    EXPECT_NEAR(ground_height(ground(), {x, 7.0}, 0.2 * (x + 10)), 0.2 * (x + 10), 0.005) << x;
  }
}

TEST(SurveyGround, ARampBelongsToTheFloorFromWhichItRises) {
  EXPECT_EQ(surface_near(ground(), {-5.0, 7.0}, 1.0)->level, 0);
  EXPECT_EQ(surface_near(ground(), {4.5, 7.0}, 2.9)->level, 1);
}

TEST(SurveyGround, TopsOfWallsAndEdgesAreNotDrivable) {
  const GroundSurface* wall = surface_near(ground(), {1.05, 3.05}, 1.2);
  ASSERT_NE(wall, nullptr);
  EXPECT_NEAR(wall->z, 1.18, 0.5 * kSurveyVoxel);  // The mean of its top voxel.
  EXPECT_FALSE(wall->drivable);
  EXPECT_FALSE(surface_near(ground(), {5.05, 3.05}, 3.0)->drivable);
  EXPECT_TRUE(surface_near(ground(), {5.35, 3.05}, 3.0)->drivable);
}

TEST(SurveyGround, WhatHasNoRoomAboveIsNoGround) {
  GroundConfig tall;
  tall.clearance = 2.9;
  const ElevationMap map = survey_ground(two_floors(), tall);
  EXPECT_EQ(map.at(map.frame.cell_of(map.frame.T_map_grid.inverse() * Eigen::Vector2d(7.05, 3.05)))
                .size(),
            2U);
}

TEST(SurveyGround, WhatFacesDownIsNoGround) {
  VoxelBuilder builder(kSurveyVoxel);
  for (double x = 0.05; x < 3.0; x += kSurveyVoxel) {
    for (double y = 0.05; y < 3.0; y += kSurveyVoxel) {
      builder.add({x, y, 0.0});
      builder.add({x, y, 2.0}, false);  // The underside of something tall.
      builder.add({x, y, 5.0});
    }
  }
  const ElevationMap map = survey_ground(builder.build(), GroundConfig{});
  const auto surfaces = map.at({15, 15});
  ASSERT_EQ(surfaces.size(), 2U);
  EXPECT_NEAR(surfaces[0].clearance, 2.0, 0.001);
  EXPECT_NEAR(surfaces[1].z, 5.0, 0.001);
}

TEST(SurveyGround, SteepGroundIsNotDrivable) {
  VoxelBuilder builder(kSurveyVoxel);
  add_surface(builder, 0, 4, 0, 4, [](double x, double) { return 0.5 * x; });
  const ElevationMap map = survey_ground(builder.build(), GroundConfig{});
  const GroundSurface* steep = surface_near(map, {2.0, 2.0}, 1.0);
  EXPECT_FALSE(steep->drivable);
  EXPECT_NEAR(steep->slope_x, 0.5, 0.05);
  EXPECT_EQ(map.levels.size(), 1U);
}

TEST(SurveyGround, NothingHasNoGround) {
  EXPECT_THROW(survey_ground(VoxelMap{}, GroundConfig{}), std::invalid_argument);
  GroundConfig wrong;
  wrong.max_slope = 0.0;
  EXPECT_THROW(survey_ground(two_floors(), wrong), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
