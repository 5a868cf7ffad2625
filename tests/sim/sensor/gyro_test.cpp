#include "sim/sensor/gyro.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kGyros = 2000;

GyroConfig exact() { return {0.0, 0.0, 0.0, 0.0}; }

/// Standard deviation [deg] over many gyros of the angle after 100 readings in 10 s at rest.
double drift(const GyroConfig& config) {
  double squares = 0.0;
  for (unsigned seed = 0; seed < kGyros; ++seed) {
    Gyro gyro(config, Rng(seed));
    double angle = 0.0;
    for (int i = 0; i < 100; ++i) angle += gyro.measure(0.0, 0.1);
    squares += angle * angle;
  }
  return std::sqrt(squares / kGyros) / kDegree;
}

double gyro_tolerance(double sigma) { return 4.0 * sigma / std::sqrt(2.0 * kGyros); }

TEST(Gyro, WithoutErrorIsExact) {
  Gyro gyro(exact(), Rng(1));
  EXPECT_DOUBLE_EQ(gyro.measure(0.3, 0.01), 0.3);
}

TEST(Gyro, NoiseWalksWithTheRootOfTime) {
  GyroConfig config = exact();
  config.noise_deg = 0.1;
  EXPECT_NEAR(drift(config), 0.1 * std::sqrt(10.0), gyro_tolerance(0.1 * std::sqrt(10.0)));
}

TEST(Gyro, BiasGrowsWithTime) {
  GyroConfig config = exact();
  config.bias_deg_s = 0.05;
  EXPECT_NEAR(drift(config), 0.5, gyro_tolerance(0.5));
}

TEST(Gyro, AWalkingBiasGrowsFaster) {
  GyroConfig config = exact();
  config.bias_walk_deg_s = 0.02;
  // Sum over steps k of k dt, each of variance 0.02^2 dt: dt^3 n (n + 1) (2 n + 1) / 6.
  const double expected = 0.02 * std::sqrt(1e-3 * 100.0 * 101.0 * 201.0 / 6.0);
  EXPECT_NEAR(drift(config), expected, gyro_tolerance(expected));
}

TEST(Gyro, ScaleErrsWithTurns) {
  GyroConfig config = exact();
  config.scale_sigma = 0.01;
  double squares = 0.0;
  for (unsigned seed = 0; seed < kGyros; ++seed) {
    const double error = Gyro(config, Rng(seed)).measure(2.0, 0.1) - 2.0;
    squares += error * error;
  }
  EXPECT_NEAR(std::sqrt(squares / kGyros), 0.02, gyro_tolerance(0.02));
}

TEST(Gyro, RefusesWhatCannotBe) {
  GyroConfig config;
  config.noise_deg = -1.0;
  EXPECT_THROW(Gyro(config, Rng(1)), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
