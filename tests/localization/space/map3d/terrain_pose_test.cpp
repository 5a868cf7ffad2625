#include "localization/space/map3d/terrain_pose.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

std::optional<TerrainPose> stand_on(const ElevationMap& map, const SE2& T_map_base, double z,
                                    const WheelStance& wheels) {
  return stand(map, grid_from_map(map), T_map_base, z, wheels);
}

constexpr double kRise = 0.2;  // Of z along x.

/// A slope of 4 m x 4 m, below a level roof at 5 m that covers half of it.
ElevationMap slope() {
  ElevationMap map;
  map.frame = {40, 40, 0.1, {-2.0, -2.0, 0.0}};
  map.levels = {0.0F, 5.0F};
  map.first.push_back(0);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const double z = kRise * map.frame.centre_of({x, y}).x();
      map.surfaces.push_back({static_cast<float>(z - 2.0 * kRise), 0.2F, 0.0F, 4.0F, 0, true});
      if (y < 20) map.surfaces.push_back({5.0F, 0.0F, 0.0F, 9.0F, 1, true});
      map.first.push_back(static_cast<std::uint32_t>(map.surfaces.size()));
    }
  }
  return map;
}

const double kPitch = std::atan(kRise);

TEST(Stand, UphillTheRobotLooksUp) {
  const auto pose = stand_on(slope(), {0.5, 0.3, 0.0}, 0.0, {});
  ASSERT_TRUE(pose);
  const Eigen::Vector3d ahead = pose->T_map_base.linear().col(0);
  EXPECT_NEAR(std::asin(ahead.z()), kPitch, 1e-6);
  EXPECT_NEAR(ahead.y(), 0.0, 1e-9);
  EXPECT_NEAR(pose->T_map_base.translation().x(), 0.5, 1e-12);
  EXPECT_NEAR(pose->T_map_base.translation().z(), 0.1, 1e-6);
  EXPECT_EQ(pose->level, 0);
}

TEST(Stand, AcrossTheSlopeTheRobotLeans) {
  const auto pose = stand_on(slope(), {0.5, 0.3, M_PI_2}, 0.0, {});
  ASSERT_TRUE(pose);
  const Eigen::Matrix3d R = pose->T_map_base.linear();
  EXPECT_NEAR(R.col(0).z(), 0.0, 1e-7);                 // It does not look up,
  EXPECT_NEAR(std::asin(R.col(1).z()), -kPitch, 1e-6);  // its left side is down,
  EXPECT_NEAR(R.determinant(), 1.0, 1e-9);
  EXPECT_NEAR(R.col(2).z(), std::cos(kPitch), 1e-6);  // and it stands upright on the ground.
}

TEST(Stand, TheHeightSaysOnWhichSurface) {
  const auto above = stand_on(slope(), {0.5, -1.0, 1.0}, 4.0, {});
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->T_map_base.translation().z(), 5.0, 1e-6);
  EXPECT_EQ(above->level, 1);
  EXPECT_NEAR(std::atan2(above->T_map_base(1, 0), above->T_map_base(0, 0)), 1.0, 1e-9);
}

TEST(Stand, OnTwistedGroundOnThreeOfFourWheels) {
  ElevationMap map = slope();
  for (int y = 0, i = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const Eigen::Vector2d p = map.frame.T_map_grid * map.frame.centre_of({x, y});
      GroundSurface& surface = map.surfaces[map.first[static_cast<std::size_t>(i++)]];
      surface.z = static_cast<float>(p.x() * p.y() / 6.0);
      surface.slope_x = static_cast<float>(p.y() / 6.0);
      surface.slope_y = static_cast<float>(p.x() / 6.0);
    }
  }
  const WheelStance wheels({{0.15, 0.2}, {0.15, -0.2}, {-0.15, 0.2}, {-0.15, -0.2}},
                           {0.03, 0.0, 0.1});
  const auto pose = stand_on(map, {0.0, 0.0, 0.0}, 0.0, wheels);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->T_map_base.translation().z(), 0.005, 1e-3);
  EXPECT_NEAR(pose->T_map_base(2, 0), -0.005 / 0.15, 2e-3);
  EXPECT_NEAR(pose->T_map_base(2, 1), 0.005 / 0.2, 2e-3);
}

TEST(Stand, WithoutGroundUnderAWheelThereIsNoPose) {
  EXPECT_FALSE(stand_on(slope(), {1.95, 0.3, 0.0}, 0.0, {}));   // Ahead is off the map.
  EXPECT_FALSE(stand_on(slope(), {0.0, -0.05, 0.0}, 5.0, {}));  // The left side is off the roof.
  EXPECT_FALSE(stand_on(slope(), {5.0, 0.0, 0.0}, 0.0, {}));
}

}  // namespace
}  // namespace castaway::localization
