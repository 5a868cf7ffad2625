#include "sim/events/odometry_faults.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;

FaultSpec odometry_fault(FaultKind kind) {
  FaultSpec spec;
  spec.kind = kind;
  spec.at_s = 1.0;
  spec.for_s = 1.0;
  return spec;
}

TEST(OdometryFaults, AFreezeStopsBothWheels) {
  const OdometryFaults faults({odometry_fault(FaultKind::kOdometryFrozen)});
  EXPECT_FALSE(faults.gain(milliseconds(999)).frozen());
  EXPECT_TRUE(faults.gain(milliseconds(1000)).frozen());
  EXPECT_EQ(faults.gain(milliseconds(2000)).left, 1.0);
}

TEST(OdometryFaults, AWrongScaleGoesForBothWheels) {
  FaultSpec spec = odometry_fault(FaultKind::kOdometryScale);
  spec.scale = 1.25;
  const WheelGain gain = OdometryFaults({spec}).gain(milliseconds(1500));
  EXPECT_EQ(gain.left, 1.25);
  EXPECT_EQ(gain.right, 1.25);
}

TEST(OdometryFaults, AReversedWheelIsOneOfTheTwo) {
  FaultSpec spec = odometry_fault(FaultKind::kOdometryReversed);
  EXPECT_EQ(OdometryFaults({spec}).gain(milliseconds(1500)).right, -1.0);
  EXPECT_EQ(OdometryFaults({spec}).gain(milliseconds(1500)).left, 1.0);
  spec.reverse_right = false;
  EXPECT_EQ(OdometryFaults({spec}).gain(milliseconds(1500)).left, -1.0);
}

TEST(OdometryFaults, OverlappingOnesMultiply) {
  FaultSpec scale = odometry_fault(FaultKind::kOdometryScale);
  scale.scale = 2.0;
  const WheelGain gain = OdometryFaults({scale, odometry_fault(FaultKind::kOdometryReversed)})
                             .gain(milliseconds(1500));
  EXPECT_EQ(gain.left, 2.0);
  EXPECT_EQ(gain.right, -2.0);
}

TEST(OdometryFaults, ADropoutLosesReadings) {
  const OdometryFaults faults({odometry_fault(FaultKind::kOdometryDropout)});
  EXPECT_FALSE(faults.is_lost(milliseconds(999)));
  EXPECT_TRUE(faults.is_lost(milliseconds(1500)));
  EXPECT_EQ(faults.gain(milliseconds(1500)).left, 1.0);
}

TEST(OdometryFaults, AResetIsDueOnce) {
  OdometryFaults faults(
      {odometry_fault(FaultKind::kOdometryReset), odometry_fault(FaultKind::kLidarDropout)});
  EXPECT_FALSE(faults.reset_due(milliseconds(999)));
  EXPECT_TRUE(faults.reset_due(milliseconds(1001)));
  EXPECT_FALSE(faults.reset_due(milliseconds(1002)));
}

}  // namespace
}  // namespace castaway::sim
