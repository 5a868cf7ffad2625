#include "sim/sensor/beam_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using Eigen::Vector3d;

constexpr int kBeams = 4000;
constexpr double kMax = 12.0;
const Ray kAhead{{0.0, 0.0, 0.5}, Vector3d::UnitX()};

/// A wall at x = 5 of reflectivity 0.5.
WorldSpec wall_world() {
  WorldSpec world;
  world.objects = {box_on_floor("wall", {0.2, 8.0, 1.0}, {5.1, 0.0})};
  world.objects[0].surface.reflectivity = 0.5;
  return world;
}

/// The same wall behind a glass pane of 2 cm at x = 2.
WorldSpec glass_world(double yaw = 0.0) {
  WorldSpec world = wall_world();
  world.objects.push_back(box_on_floor("pane", {0.02, 4.0, 1.0}, {2.01, 0.0}, yaw));
  world.objects[1].surface.glass = true;
  return world;
}

/// Echoes of many equal beams.
std::vector<Echo> echoes(const WorldSpec& world, const LightEffects& effects, int count = kBeams,
                         const Ray& ray = kAhead) {
  const RayScene scene(ray_primitives(world));
  const BeamLight light(effects, Surfaces(world), kMax);
  LidarDraws draws{Rng(1), Rng(2), Rng(3), Rng(4), Rng(5), Rng(6)};
  std::vector<Echo> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(light.echo(scene, ray, Vector3d::UnitY(), draws, kNoPrimitive));
  }
  return result;
}

double share_of(const std::vector<Echo>& echoes, int object) {
  const auto count = std::count_if(echoes.begin(), echoes.end(),
                                   [object](const Echo& e) { return e.object == object; });
  return static_cast<double>(count) / static_cast<double>(echoes.size());
}

/// Four standard deviations of a share.
double tolerance(double share) { return 4.0 * std::sqrt(share * (1.0 - share) / kBeams); }

TEST(BeamLight, WithoutEffectsTellsTheSurface) {
  const Echo echo = echoes(wall_world(), {}, 1)[0];
  EXPECT_DOUBLE_EQ(echo.range, 5.0);
  EXPECT_DOUBLE_EQ(echo.cosine, 1.0);
  EXPECT_DOUBLE_EQ(echo.reflectivity, 0.5);
  EXPECT_TRUE(echo.met);
}

TEST(BeamLight, GlassIsAWallUnlessItIsSwitchedOn) {
  EXPECT_DOUBLE_EQ(echoes(glass_world(), {}, 1)[0].range, 2.0);
}

TEST(BeamLight, APaneMirrorsAShareNearItsNormalAndLetsTheRestThrough) {
  LightEffects effects;
  effects.glass = true;
  effects.glass_return = 0.3;
  const auto seen = echoes(glass_world(), effects);
  EXPECT_NEAR(share_of(seen, 1), 0.3, tolerance(0.3));
  EXPECT_NEAR(share_of(seen, 0), 0.7, tolerance(0.3));
  for (const Echo& echo : seen) {
    EXPECT_NEAR(echo.range, echo.object == 1 ? 2.0 : 5.0, 1e-9);
    EXPECT_DOUBLE_EQ(echo.reflectivity, echo.object == 1 ? 1.0 : 0.5);
  }
}

TEST(BeamLight, APaneAtAnAngleMirrorsNothing) {
  LightEffects effects;
  effects.glass = true;
  effects.glass_return = 1.0;
  effects.glass_angle_deg = 5.0;
  const double degree = std::numbers::pi / 180.0;
  EXPECT_EQ(echoes(glass_world(4.0 * degree), effects, 1)[0].object, 1);
  EXPECT_EQ(echoes(glass_world(6.0 * degree), effects, 1)[0].object, 0);
}

TEST(BeamLight, BehindGlassMayBeNothing) {
  LightEffects effects;
  effects.glass = true;
  effects.glass_return = 0.0;
  WorldSpec world = glass_world();
  world.objects[0].T_map_object.translation().x() = 50.0;
  const Echo echo = echoes(world, effects, 1)[0];
  EXPECT_EQ(echo.object, kHitNothing);
  EXPECT_TRUE(echo.met);
}

TEST(BeamLight, LosesTheShareThatItsFieldsSay) {
  LightEffects effects;
  effects.dropout = 0.1;
  effects.dropout_far = 0.8;
  const double lost = 1.0 - 0.9 * (1.0 - 0.8 * 25.0 / 144.0);
  EXPECT_NEAR(share_of(echoes(wall_world(), effects), kHitNothing), lost, tolerance(lost));
}

TEST(BeamLight, LosesMoreAtGrazingIncidence) {
  LightEffects effects;
  effects.dropout_grazing = 0.8;
  const Ray slanted{kAhead.origin, Vector3d(0.5, std::sqrt(0.75), 0.0)};
  WorldSpec world = wall_world();
  world.objects[0].T_map_object.translation().y() = 8.0;
  const double lost = 0.8 * 0.5;
  EXPECT_NEAR(share_of(echoes(world, effects, kBeams, slanted), kHitNothing), lost,
              tolerance(lost));
}

TEST(BeamLight, DarkThingsAreSeenOnlyNearby) {
  LightEffects effects;
  effects.dark_range = 10.0;
  WorldSpec world = wall_world();
  world.objects[0].surface.reflectivity = 0.026;  // Detectable up to 5.1 m.
  EXPECT_EQ(echoes(world, effects, 1)[0].object, 0);
  world.objects[0].surface.reflectivity = 0.024;  // Detectable up to 4.9 m.
  EXPECT_EQ(echoes(world, effects, 1)[0].object, kHitNothing);
}

TEST(BeamLight, DustShortensTheShareThatMeetsAGrain) {
  LightEffects effects;
  effects.dust_rate = 0.05;
  effects.dust_range = 4.0;
  const auto seen = echoes(wall_world(), effects);
  const double expected = 1.0 - std::exp(-0.05 * 4.0);
  EXPECT_NEAR(share_of(seen, kHitDust), expected, tolerance(expected));
  for (const Echo& echo : seen) {
    EXPECT_LE(echo.range, echo.object == kHitDust ? 4.0 : 5.0);
  }
}

/// At 2 m, the box's edge is 2 mm off the beam's centre: half of the beam misses it.
TEST(BeamLight, AtAnEdgeRangesLieAnywhereBetweenTheTwo) {
  WorldSpec world = wall_world();
  world.objects.push_back(box_on_floor("near", {0.2, 1.0, 1.0}, {4.8, 0.502}));
  LightEffects effects;
  effects.divergence_deg = 0.5;  // The beam is 2 cm wide at 4.7 m.
  const auto seen = echoes(world, effects);
  double sum = 0.0;
  for (const Echo& echo : seen) {
    EXPECT_GE(echo.range, 4.7 - 1e-4);
    EXPECT_LE(echo.range, 5.0 + 1e-4);
    sum += echo.range;
  }
  EXPECT_NEAR(sum / kBeams, 4.85, 4.0 * 0.3 / std::sqrt(12.0 * kBeams));
  effects.mixed_reach = 0.2;  // The step of 0.3 m is resolved.
  EXPECT_NEAR(echoes(world, effects, 1)[0].range, 5.0, 1e-4);
}

TEST(BeamLight, AwayFromEdgesABeamOfSomeWidthIsExactOnAWallAtARightAngle) {
  LightEffects effects;
  effects.divergence_deg = 0.5;
  for (const Echo& echo : echoes(wall_world(), effects, 50)) EXPECT_NEAR(echo.range, 5.0, 1e-4);
}

TEST(BeamLight, DustShiftsNoOtherEffect) {
  LightEffects effects;
  effects.dropout = 0.3;
  const auto without = echoes(wall_world(), effects, 500);
  effects.dust_rate = 0.1;
  const auto with = echoes(wall_world(), effects, 500);
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_TRUE(with[i].object == kHitDust || with[i].object == without[i].object);
  }
}

}  // namespace
}  // namespace castaway::sim
