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

TEST(SensorStreams, EffectsWithoutStreamsAreAnError) {
  LidarConfig lidar;
  lidar.light.dropout = 0.1;
  EXPECT_THROW(lidar_draws(test_streams(1), lidar), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
