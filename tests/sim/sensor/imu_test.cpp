#include "sim/sensor/imu.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr ImuConfig kPerfectImu{100.0, 0.0, 0.0, 0.0, 0.0};

/// Readings while base moves as `pose` says, in steps of 2 ms.
template <typename PoseAt>
std::vector<ImuReading> readings(Imu& imu, double seconds, const PoseAt& pose) {
  std::vector<ImuReading> all;
  const int steps = static_cast<int>(std::lround(seconds / 0.002));
  for (int i = 0; i < steps; ++i) {
    const Motion motion{milliseconds(2 * i), milliseconds(2 * i + 2), pose(0.002 * i),
                        pose(0.002 * (i + 1))};
    for (const ImuReading& reading : imu.read(motion, false)) all.push_back(reading);
  }
  return all;
}

TEST(Imu, MeasuresGravityAtRestOnASlope) {
  Imu imu(kPerfectImu, Rng(1));
  const Eigen::AngleAxisd pitch(-0.2, Eigen::Vector3d::UnitY());
  const auto all = readings(imu, 1.0, [&](double) { return Eigen::Isometry3d(pitch); });
  ASSERT_EQ(all.size(), 100U);
  for (const ImuReading& reading : all) {
    EXPECT_NEAR(reading.linear_acceleration.x(), 9.81 * std::sin(0.2), 1e-9);  // Nose up.
    EXPECT_NEAR(reading.linear_acceleration.z(), 9.81 * std::cos(0.2), 1e-9);
    EXPECT_EQ(reading.angular_velocity.norm(), 0.0);
  }
  EXPECT_EQ(all[1].stamp, milliseconds(10));
}

TEST(Imu, MeasuresACircle) {
  Imu imu(kPerfectImu, Rng(1));
  constexpr double kRate = 0.8;    // [rad/s]
  constexpr double kRadius = 0.5;  // [m]
  const auto all = readings(imu, 2.0, [&](double t) {
    const double a = kRate * t;
    return to_isometry({kRadius * std::sin(a), kRadius * (1.0 - std::cos(a)), a});
  });
  for (std::size_t i = 3; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].angular_velocity.z(), kRate, 1e-6);
    EXPECT_NEAR(all[i].linear_acceleration.y(), kRate * kRate * kRadius, 0.01);  // To the left.
    EXPECT_NEAR(all[i].linear_acceleration.x(), 0.0, 0.01);
  }
}

TEST(Imu, DoesNotFeelThatItIsPutElsewhere) {
  Imu imu(kPerfectImu, Rng(1));
  const auto at = [](double x) { return to_isometry({x, 0.0, 0.0}); };
  for (int i = 0; i < 100; ++i) {
    const double x = i < 50 ? 0.0 : 10.0;
    const Motion motion{milliseconds(2 * i), milliseconds(2 * i + 2), at(x), at(x)};
    for (const ImuReading& reading : imu.read(motion, i == 50)) {
      EXPECT_NEAR(reading.linear_acceleration.head<2>().norm(), 0.0, 1e-9);
    }
  }
}

TEST(Imu, ErrsAsItsSettingsSay) {
  ImuConfig config;
  double square_of_bias = 0.0;
  double square_of_noise = 0.0;
  constexpr int kUnits = 400;
  for (int unit = 0; unit < kUnits; ++unit) {
    Imu imu(config, Rng(static_cast<std::uint64_t>(unit) + 1));
    const auto all =
        readings(imu, 1.0, [](double) { return Eigen::Isometry3d(Eigen::Isometry3d::Identity()); });
    double mean = 0.0;
    for (const ImuReading& reading : all) mean += reading.linear_acceleration.x() / 100.0;
    square_of_bias += mean * mean / kUnits;
    for (const ImuReading& reading : all) {
      square_of_noise += std::pow(reading.linear_acceleration.x() - mean, 2) / (99.0 * kUnits);
    }
  }
  EXPECT_NEAR(std::sqrt(square_of_noise), config.accel_noise, 0.001);
  EXPECT_NEAR(std::sqrt(square_of_bias), config.accel_bias, 0.006);
}

TEST(Imu, RefusesImpossibleSettings) {
  EXPECT_THROW(validate(ImuConfig{0.0}), std::invalid_argument);
  EXPECT_THROW(validate(ImuConfig{100.0, -1.0}), std::invalid_argument);
  EXPECT_NO_THROW(validate(ImuConfig{}));
}

}  // namespace
}  // namespace castaway::sim
