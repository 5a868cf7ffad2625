#include "sim/sensor/range_noise.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

constexpr RangeNoise kNoNoise{0.0, 0.0, 0.0, 0.0, 0.0};

constexpr int kDraws = 20000;

/// Mean and standard deviation of many measurements.
std::pair<double, double> moments(const RangeNoise& noise, double range) {
  Rng rng(3);
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double error = measure_range(noise, range, 0.0, rng) - range;
    sum += error;
    squares += error * error;
  }
  const double mean = sum / kDraws;
  return {mean, std::sqrt(squares / kDraws - mean * mean)};
}

TEST(RangeNoise, WithoutErrorIsExactAndDrawsNothing) {
  Rng rng(1);
  EXPECT_EQ(measure_range(kNoNoise, 3.7, 0.0, rng), 3.7);
  EXPECT_EQ(rng, Rng(1));
}

TEST(RangeNoise, BiasIsAdded) {
  RangeNoise noise = kNoNoise;
  noise.bias = -0.02;
  Rng rng(1);
  EXPECT_DOUBLE_EQ(measure_range(noise, 3.0, 0.005, rng), 2.985);
}

TEST(RangeNoise, RoundsToItsResolution) {
  RangeNoise noise = kNoNoise;
  noise.resolution = 0.01;
  Rng rng(1);
  EXPECT_DOUBLE_EQ(measure_range(noise, 1.2345, 0.0, rng), 1.23);
  EXPECT_DOUBLE_EQ(measure_range(noise, 1.2351, 0.0, rng), 1.24);
}

TEST(RangeNoise, DeviatesByItsConstantAndItsShareOfRange) {
  RangeNoise noise = kNoNoise;
  noise.sigma = 0.01;
  noise.sigma_relative = 0.02;
  const auto [mean, sigma] = moments(noise, 2.0);
  EXPECT_NEAR(mean, 0.0, 4.0 * 0.05 / std::sqrt(kDraws));
  EXPECT_NEAR(sigma, 0.05, 4.0 * 0.05 / std::sqrt(2.0 * kDraws));
}

TEST(RangeNoise, RefusesWhatCannotBe) {
  RangeNoise noise;
  noise.resolution = -0.01;
  EXPECT_THROW(validate(noise), std::invalid_argument);
  noise = {};
  noise.bias = NAN;
  EXPECT_THROW(validate(noise), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
