#include "sim/stages/sensor_streams.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

TEST(SensorStreams, TheDefaultLidarsNoiseIsTheRunsLidarStream) {
  EXPECT_EQ(lidar_draws(test_streams(1), LidarConfig{}).noise, test_streams(1).lidar);
}

TEST(SensorStreams, OthersAreNamedByLidarAndEffect) {
  SimulationStreams streams = test_streams(1);
  streams.named = named_streams(1);
  LidarConfig lidar;
  lidar.name = "rear";
  lidar.light.dropout = 0.1;
  const LidarDraws draws = lidar_draws(streams, lidar);
  EXPECT_EQ(draws.noise, streams.named("lidar/rear/noise"));
  EXPECT_EQ(draws.dropout, streams.named("lidar/rear/dropout"));
  EXPECT_NE(draws.dropout, draws.dust);
}

TEST(SensorStreams, ErrorsOfStampsHaveTheirOwn) {
  SimulationStreams streams = test_streams(1);
  streams.named = named_streams(1);
  LidarConfig lidar;
  lidar.name = "rear";
  const LidarDraws without = lidar_draws(streams, lidar);
  EXPECT_EQ(without.stamps, Rng{});
  lidar.stamp_sigma = 0.02;
  const LidarDraws draws = lidar_draws(streams, lidar);
  EXPECT_EQ(draws.stamps, streams.named("lidar/rear/stamps"));
  EXPECT_EQ(draws.noise, without.noise);
}

TEST(SensorStreams, EffectsWithoutStreamsAreAnError) {
  LidarConfig lidar;
  lidar.light.dropout = 0.1;
  EXPECT_THROW(lidar_draws(test_streams(1), lidar), std::invalid_argument);
  lidar.light.dropout = 0.0;
  EXPECT_NO_THROW(lidar_draws(test_streams(1), lidar));
  lidar.stamp_sigma = 0.1;
  EXPECT_THROW(lidar_draws(test_streams(1), lidar), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
