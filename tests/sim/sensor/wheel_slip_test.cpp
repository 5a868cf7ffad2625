#include "sim/sensor/wheel_slip.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

constexpr double kRadius = 0.05;  // [m]
const DriveGeometry kSlippingDrive{kRadius, kRadius, 0.4, {0.0, 0.0}};

/// Ice from x = 1 to 2 on the left of the x axis.
std::vector<SlipZone> ice() { return {{"ice", {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, 0.2}}; }

SlipConfig even() {
  SlipConfig config;
  config.zone_spread = 0.0;
  return config;
}

/// Distance [m] measured by each wheel while the robot drives along x in steps of 1 mm.
WheelAngles drive(WheelSlip slip, double from, double to, std::int64_t collisions = 0) {
  WheelAngles sum;
  const double step = 0.001;
  for (double x = from; x < to - 1e-9; x += step) {
    const WheelAngles counted =
        slip.count({step / kRadius, step / kRadius}, {x, 0.0, 0.0}, collisions);
    sum.left += kRadius * counted.left;
    sum.right += kRadius * counted.right;
  }
  return sum;
}

TEST(WheelSlip, WithoutEventsAndZonesIsNone) {
  const WheelAngles way = drive(WheelSlip(SlipConfig{}, kSlippingDrive, {}, Rng(1)), 0.0, 3.0);
  EXPECT_NEAR(way.left, 3.0, 1e-9);
  EXPECT_NEAR(way.right, 3.0, 1e-9);
}

/// A share of 0.2 is lost: the wheel turns by 1 / 0.8 for every metre.
TEST(WheelSlip, OnIceAWheelTurnsFurther) {
  const WheelAngles way = drive(WheelSlip(even(), kSlippingDrive, ice(), Rng(1)), 0.0, 3.0);
  EXPECT_NEAR(way.left, 2.0 + 1.0 / 0.8, 1e-3);
  EXPECT_NEAR(way.right, 3.0, 1e-9);
}

TEST(WheelSlip, ZonesCanBeLeftOut) {
  SlipConfig config = even();
  config.zones = false;
  EXPECT_NEAR(drive(WheelSlip(config, kSlippingDrive, ice(), Rng(1)), 0.0, 3.0).left, 3.0, 1e-9);
}

TEST(WheelSlip, EventsComeAsOftenAndLastAsLongAsTheySay) {
  SlipConfig config;
  config.rate = 2.0;
  config.length = 0.05;
  config.share = 0.3;
  // 2000 m: 4000 events per wheel of 0.05 m, minus overlaps; shares are uniform in 0 to 0.6.
  const double metres = 2000.0;
  const WheelAngles way = drive(WheelSlip(config, kSlippingDrive, {}, Rng(1)), 0.0, metres);
  const double slipping = 1.0 - std::exp(-config.rate * config.length);
  const double excess = -std::log(1.0 - 0.6) / 0.6 - 1.0;  // Mean of 1 / (1 - s) - 1.
  const double expected = metres * slipping * excess;
  EXPECT_NEAR(way.left - metres, expected, 0.06 * expected);
  EXPECT_NEAR(way.right - metres, expected, 0.06 * expected);
  EXPECT_NE(way.left, way.right);
}

TEST(WheelSlip, ACollisionMakesBothWheelsSpin) {
  SlipConfig config;
  config.collision_length = 0.1;
  WheelSlip slip(config, kSlippingDrive, {}, Rng(3));
  EXPECT_EQ(slip.count({1e-3, 1e-3}, {}, 0).left, 1e-3);
  const WheelAngles spun = slip.count({1e-3, 1e-3}, {}, 1);
  EXPECT_GT(spun.left, 1e-3);
  EXPECT_GT(spun.right, 1e-3);
  EXPECT_NEAR(drive(slip, 0.0, 0.1, 1).left, drive(slip, 0.0, 1.0, 1).left - 0.9, 2e-3);
}

TEST(WheelSlip, BackwardsSlipsBackwards) {
  WheelSlip slip(even(), kSlippingDrive, ice(), Rng(1));
  EXPECT_DOUBLE_EQ(slip.count({-0.01, -0.01}, {1.5, 0.0, 0.0}, 0).left, -0.0125);
}

TEST(WheelSlip, RefusesWhatCannotBe) {
  SlipConfig config;
  config.share = 0.8;
  EXPECT_THROW(WheelSlip(config, kSlippingDrive, {}, Rng(1)), std::invalid_argument);
}

TEST(Contains, InAndOutOfAnAngle) {
  const std::vector<Eigen::Vector2d> angle = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_TRUE(contains(angle, {0.5, 1.5}));
  EXPECT_TRUE(contains(angle, {1.5, 0.5}));
  EXPECT_FALSE(contains(angle, {1.5, 1.5}));
  EXPECT_FALSE(contains(angle, {-0.5, 0.5}));
}

}  // namespace
}  // namespace castaway::sim
