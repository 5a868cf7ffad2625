#include "sim/events/lidar_faults.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A lidar with eight beams, one every 45 degrees from -180 on.
LidarConfig eight_beams(const std::string& name = "lidar") {
  LidarConfig config;
  config.name = name;
  config.beams = 8;
  config.angle_increment = std::numbers::pi / 4;
  return config;
}

/// A scan whose ranges are all equal.
Sweep sweep(int ms, float range) {
  Sweep result;
  result.reading.stamp = milliseconds(ms);
  result.reading.ranges.assign(8, range);
  result.reading.hit_object.assign(8, 0);
  result.last_beam = milliseconds(ms + 90);
  return result;
}

FaultSpec fault(FaultKind kind) {
  FaultSpec spec;
  spec.kind = kind;
  spec.at_s = 1.0;
  spec.for_s = 1.0;
  return spec;
}

TEST(LidarFaults, WithoutAnyScansPassAsTheyAre) {
  LidarFaults faults({}, eight_beams());
  const auto passed = faults.deliver(sweep(1500, 2.0F));
  EXPECT_EQ(passed->last_beam, milliseconds(1590));
  EXPECT_EQ(passed->reading.ranges[3], 2.0F);
}

TEST(LidarFaults, ADropoutLosesScansWhileItLasts) {
  LidarFaults faults({fault(FaultKind::kLidarDropout)}, eight_beams());
  EXPECT_TRUE(faults.deliver(sweep(900, 1.0F)).has_value());
  EXPECT_FALSE(faults.deliver(sweep(1000, 1.0F)).has_value());
  EXPECT_FALSE(faults.deliver(sweep(1900, 1.0F)).has_value());
  EXPECT_TRUE(faults.deliver(sweep(2000, 1.0F)).has_value());
}

TEST(LidarFaults, MeanOneLidarOrAll) {
  FaultSpec spec = fault(FaultKind::kLidarDropout);
  spec.lidar = "front";
  EXPECT_FALSE(LidarFaults({spec}, eight_beams("front")).deliver(sweep(1500, 1.0F)).has_value());
  EXPECT_TRUE(LidarFaults({spec}, eight_beams("rear")).deliver(sweep(1500, 1.0F)).has_value());
  spec.lidar.clear();
  EXPECT_FALSE(LidarFaults({spec}, eight_beams("rear")).deliver(sweep(1500, 1.0F)).has_value());
}

TEST(LidarFaults, AFreezeRepeatsTheLastScanWithNewStamps) {
  LidarFaults faults({fault(FaultKind::kLidarFrozen)}, eight_beams());
  (void)faults.deliver(sweep(800, 1.0F));
  (void)faults.deliver(sweep(900, 2.0F));
  const auto frozen = faults.deliver(sweep(1500, 3.0F));
  EXPECT_EQ(frozen->reading.stamp, milliseconds(1500));
  EXPECT_EQ(frozen->reading.ranges, std::vector<float>(8, 2.0F));
  EXPECT_EQ(faults.deliver(sweep(2000, 4.0F))->reading.ranges[0], 4.0F);
}

/// Number of beams, one every degree, that end on a cover.
int beams_on_the_cloth(double from_deg, double to_deg) {
  LidarConfig lidar;
  lidar.beams = 360;
  lidar.angle_increment = std::numbers::pi / 180.0;
  FaultSpec spec = fault(FaultKind::kLidarBlocked);
  spec.from_deg = from_deg;
  spec.to_deg = to_deg;
  spec.distance = 0.25;
  Sweep full = sweep(1500, 2.0F);
  full.reading.ranges.assign(360, 2.0F);
  full.reading.hit_object.assign(360, 0);
  const auto blocked = LidarFaults({spec}, lidar).deliver(std::move(full));
  return static_cast<int>(
      std::count(blocked->reading.ranges.begin(), blocked->reading.ranges.end(), 0.25F));
}

TEST(LidarFaults, ACoverOfAFullTurnBlocksEveryBeam) {
  EXPECT_EQ(beams_on_the_cloth(-180.0, 180.0), 360);
  EXPECT_EQ(beams_on_the_cloth(0.0, 360.0), 360);
  EXPECT_EQ(beams_on_the_cloth(180.0, -180.0), 360);
  EXPECT_EQ(beams_on_the_cloth(-360.0, 360.0), 360);
}

TEST(LidarFaults, ACoverReachesAcrossTheBack) {
  EXPECT_EQ(beams_on_the_cloth(0.0, 180.0), 181);
  EXPECT_EQ(beams_on_the_cloth(90.0, -90.0), 181);
  EXPECT_EQ(beams_on_the_cloth(170.0, 190.0), 21);
  EXPECT_EQ(beams_on_the_cloth(170.0, -170.0), 21);
  EXPECT_EQ(beams_on_the_cloth(-10.0, 10.0), 21);
  EXPECT_EQ(beams_on_the_cloth(10.0, -10.0), 341);
}

TEST(LidarFaults, ACoverBlocksItsSectorAndNothingElse) {
  FaultSpec spec = fault(FaultKind::kLidarBlocked);
  spec.from_deg = -45.0;
  spec.to_deg = 0.0;
  spec.distance = 0.25;
  const auto passed = LidarFaults({spec}, eight_beams()).deliver(sweep(1500, 3.0F));
  // Beams at -180, -135, -90, -45, 0...
  EXPECT_EQ(passed->reading.ranges,
            (std::vector<float>{3.0F, 3.0F, 3.0F, 0.25F, 0.25F, 3.0F, 3.0F, 3.0F}));
  EXPECT_EQ(passed->reading.hit_object[3], kHitCover);
  EXPECT_EQ(passed->reading.hit_object[2], 0);
}

TEST(LidarFaults, ACoverAcrossTheBackWrapsRound) {
  FaultSpec spec = fault(FaultKind::kLidarBlocked);
  spec.from_deg = 130.0;
  spec.to_deg = -170.0;
  spec.distance = 0.05;  // Below the lidar's minimum range.
  const auto passed = LidarFaults({spec}, eight_beams()).deliver(sweep(1500, 3.0F));
  EXPECT_EQ(passed->reading.ranges,
            (std::vector<float>{-kInfinity, 3.0F, 3.0F, 3.0F, 3.0F, 3.0F, 3.0F, -kInfinity}));
}

TEST(LidarFaults, AWrongMountIsToldBesideTheScan) {
  FaultSpec spec = fault(FaultKind::kLidarMount);
  spec.mount_error = {0.1, -0.2, 0.3};
  LidarFaults faults({spec}, eight_beams());
  EXPECT_FALSE(faults.deliver(sweep(900, 1.0F))->reading.mount_error.has_value());
  EXPECT_EQ(faults.deliver(sweep(1000, 1.0F))->reading.mount_error, spec.mount_error);
}

TEST(LidarFaults, LateScansKeepTheirStamp) {
  FaultSpec spec = fault(FaultKind::kLidarLate);
  spec.delay_s = 0.3;
  const auto late = LidarFaults({spec}, eight_beams()).deliver(sweep(1500, 1.0F));
  EXPECT_EQ(late->reading.stamp, milliseconds(1500));
  EXPECT_EQ(late->last_beam, milliseconds(1890));
}

TEST(LidarFaults, AFastClockShiftsStampsAndNoDelivery) {
  FaultSpec spec = fault(FaultKind::kLidarClock);
  spec.offset_s = 0.2;
  const auto fast = LidarFaults({spec}, eight_beams()).deliver(sweep(1500, 1.0F));
  EXPECT_EQ(fast->reading.stamp, milliseconds(1700));
  EXPECT_EQ(fast->last_beam, milliseconds(1590));
}

}  // namespace
}  // namespace castaway::sim
