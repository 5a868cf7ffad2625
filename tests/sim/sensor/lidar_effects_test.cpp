#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/sensor/lidar.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

constexpr RangeNoise kExactRanges{0.0, 0.0, 0.0, 0.0, 0.0};

using std::numbers::pi;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Eigen::Isometry3d kOrigin = Eigen::Isometry3d::Identity();

/// A wall at x = 2 of reflectivity 0.5, 1 m high.
WorldSpec one_wall() {
  WorldSpec world;
  world.objects = {box_on_floor("wall", {0.2, 8.0, 1.0}, {2.1, 0.0})};
  world.objects[0].surface.reflectivity = 0.5;
  return world;
}

/// One forward beam at 0.5 m above the floor, and one 60 degrees to its left.
LidarConfig two_beams() {
  LidarConfig config;
  config.T_base_laser = Eigen::Translation3d(0.0, 0.0, 0.5);
  config.beams = 2;
  config.angle_min = 0.0;
  config.angle_increment = pi / 3;
  config.noise = kExactRanges;
  return config;
}

Beam beam(const LidarConfig& config, int index) {
  const WorldSpec world = one_wall();
  const RayScene scene(ray_primitives(world));
  LidarDraws draws;
  return Lidar(config, Surfaces(world)).cast(scene, kOrigin, index, draws);
}

TEST(LidarIntensity, IsReceivedPower) {
  LidarConfig config = two_beams();
  config.intensity = Intensity::kPower;
  EXPECT_FLOAT_EQ(beam(config, 0).intensity, 0.5F / 4.0F);
  EXPECT_FLOAT_EQ(beam(config, 1).intensity, 0.5F * 0.5F / 16.0F);
}

TEST(LidarIntensity, OrReflectivityWhateverTheRange) {
  LidarConfig config = two_beams();
  config.intensity = Intensity::kReflectivity;
  EXPECT_FLOAT_EQ(beam(config, 0).intensity, 0.5F);
  EXPECT_FLOAT_EQ(beam(config, 1).intensity, 0.25F);
}

TEST(LidarIntensity, ChangesNoRange) {
  LidarConfig plain;
  LidarConfig bright;
  bright.intensity = Intensity::kPower;
  const WorldSpec world = one_wall();
  const RayScene scene(ray_primitives(world));
  LidarDraws a;
  LidarDraws b;
  for (int i = 0; i < plain.beams; ++i) {
    EXPECT_EQ(Lidar(plain, Surfaces(world)).cast(scene, kOrigin, i, a).range,
              Lidar(bright, Surfaces(world)).cast(scene, kOrigin, i, b).range);
  }
}

TEST(LidarPattern, EveryBeamKeepsItsOffset) {
  LidarConfig config = two_beams();
  config.noise.beam_bias_sigma = 0.01;
  const WorldSpec world = one_wall();
  const RayScene scene(ray_primitives(world));
  const Lidar lidar(config, Surfaces(world), Rng(5));
  LidarDraws draws;
  const float first = lidar.cast(scene, kOrigin, 0, draws).range;
  EXPECT_EQ(lidar.cast(scene, kOrigin, 0, draws).range, first);
  EXPECT_NE(first, 2.0F);
  EXPECT_NE(lidar.cast(scene, kOrigin, 1, draws).range - 4.0F, first - 2.0F);
}

TEST(LidarPattern, OffsetsHaveTheirSigma) {
  LidarConfig config = two_beams();
  config.beams = 4000;
  config.angle_increment = 1e-6;
  config.noise.beam_bias_sigma = 0.01;
  const WorldSpec world = one_wall();
  const RayScene scene(ray_primitives(world));
  const Lidar lidar(config, Surfaces(world), Rng(5));
  LidarDraws draws;
  double squares = 0.0;
  for (int i = 0; i < config.beams; ++i) {
    const double error = lidar.cast(scene, kOrigin, i, draws).range - 2.0;
    squares += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.01, 4.0 * 0.01 / std::sqrt(2.0 * 4000));
}

TEST(LidarEffects, ALostBeamIsNoReturnAndShiftsNoNoise) {
  LidarConfig config = two_beams();
  config.noise.sigma = 0.01;
  const WorldSpec world = one_wall();
  const RayScene scene(ray_primitives(world));
  const Lidar plain(config, Surfaces(world));
  config.light.dropout = 0.5;
  const Lidar lossy(config, Surfaces(world));
  LidarDraws a;
  LidarDraws b;
  int lost = 0;
  for (int i = 0; i < 200; ++i) {
    const float expected = plain.cast(scene, kOrigin, 0, a).range;
    const float range = lossy.cast(scene, kOrigin, 0, b).range;
    EXPECT_TRUE(range == kInfinity || range == expected);
    lost += range == kInfinity ? 1 : 0;
  }
  EXPECT_GT(lost, 70);
  EXPECT_LT(lost, 130);
}

TEST(LidarLayers, MeetTheFloorInRings) {
  LidarConfig config = two_beams();
  config.elevations = {-pi / 6, -pi / 12, 0.0};
  config.angle_min = pi;  // Away from the wall.
  for (int layer = 0; layer < 2; ++layer) {
    const double elevation = config.elevations[static_cast<std::size_t>(layer)];
    const Beam ring = beam(config, 2 * layer);
    EXPECT_NEAR(ring.range, 0.5 / std::sin(-elevation), 1e-6);
    EXPECT_EQ(ring.object, kHitFloor);
  }
  EXPECT_EQ(beam(config, 4).range, kInfinity);
}

TEST(LidarLayers, MeetAWallAsHighAsItIs) {
  LidarConfig config = two_beams();
  // At 2 m, the upper edge of the wall is 0.5 m above the lidar: 14.04 degrees.
  config.elevations = {14.0 * pi / 180.0, 14.1 * pi / 180.0};
  EXPECT_NEAR(beam(config, 0).range, 2.0 / std::cos(14.0 * pi / 180.0), 1e-6);
  EXPECT_EQ(beam(config, 2).range, kInfinity);
}

TEST(LidarLayers, AScanHoldsThemOneAfterTheOther) {
  LidarConfig config = two_beams();
  config.elevations = {-pi / 6, 0.0};
  const WorldSpec world = one_wall();
  const RayScene scene(ray_primitives(world));
  LidarSweeper sweeper(config, Surfaces(world));
  const Motion motion{{}, std::chrono::milliseconds(100), kOrigin, kOrigin};
  const auto scans = sweeper.advance(scene, motion);
  ASSERT_EQ(scans.size(), 1U);
  const LidarReading& reading = scans[0].reading;
  EXPECT_EQ(reading.layers, 2);
  ASSERT_EQ(reading.ranges.size(), 4U);
  EXPECT_NEAR(reading.ranges[0], 1.0, 1e-6);  // The floor in front of the wall.
  EXPECT_NEAR(reading.ranges[2], 2.0, 1e-6);
  EXPECT_NEAR(reading.ranges[3], 4.0, 1e-5);
  EXPECT_EQ(scans[0].last_beam, reading.time_increment);
  EXPECT_TRUE(reading.intensities.empty());
}

}  // namespace
}  // namespace castaway::sim
