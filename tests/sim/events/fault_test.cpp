#include "sim/events/fault.hpp"

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

FaultSpec fault(FaultKind kind, double at_s, double for_s) {
  FaultSpec spec;
  spec.kind = kind;
  spec.at_s = at_s;
  spec.for_s = for_s;
  return spec;
}

TEST(Fault, EveryKindHasANameOfItsOwnThatBeginsWithItsSensor) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    const auto kind = static_cast<FaultKind>(i);
    names.insert(to_string(kind));
    EXPECT_THAT(to_string(kind),
                testing::StartsWith(is_lidar_fault(kind) ? "lidar-" : "odometry-"));
  }
  EXPECT_EQ(names.size(), kFaultNames.size());
  EXPECT_EQ(std::string(to_string(FaultKind::kOdometryReset)), "odometry-reset");
}

TEST(Fault, LastsFromItsBeginToBeforeItsEnd) {
  const FaultSpec dropout = fault(FaultKind::kLidarDropout, 2.0, 1.5);
  EXPECT_FALSE(is_active(dropout, milliseconds(1999)));
  EXPECT_TRUE(is_active(dropout, milliseconds(2000)));
  EXPECT_TRUE(is_active(dropout, milliseconds(3499)));
  EXPECT_FALSE(is_active(dropout, milliseconds(3500)));
  EXPECT_FALSE(is_active(fault(FaultKind::kOdometryReset, 2.0, 1.0), milliseconds(2500)));
}

TEST(Fault, NamesTheFieldThatIsWrong) {
  FaultSpec wrong = fault(FaultKind::kOdometryScale, 1.0, 1.0);
  wrong.scale = -1.0;
  try {
    validate(wrong);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("fault odometry-scale: scale is -1"));
  }
  EXPECT_THROW(validate(fault(FaultKind::kLidarLate, -1.0, 1.0)), std::invalid_argument);
  EXPECT_THROW(validate(fault(FaultKind::kLidarLate, 1.0, 0.0)), std::invalid_argument);
  EXPECT_THROW(validate(fault(FaultKind::kLidarLate, NAN, 1.0)), std::invalid_argument);
}

TEST(FaultTimeline, TellsBeginningsAndEndsInOrderOnce) {
  FaultTimeline timeline({fault(FaultKind::kLidarFrozen, 3.0, 4.0),
                          fault(FaultKind::kOdometryReset, 5.0, 1.0),
                          fault(FaultKind::kLidarDropout, 1.0, 3.0)});
  EXPECT_TRUE(timeline.take_due(milliseconds(999)).empty());
  const auto first = timeline.take_due(seconds(1));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].kind, FaultKind::kLidarDropout);
  EXPECT_TRUE(first[0].begins);
  const auto rest = timeline.take_due(seconds(100));
  ASSERT_EQ(rest.size(), 4U);
  EXPECT_EQ(rest[0].stamp, seconds(3));
  EXPECT_EQ(rest[1].stamp, seconds(4));
  EXPECT_FALSE(rest[1].begins);
  EXPECT_EQ(rest[2].kind, FaultKind::kOdometryReset);
  EXPECT_EQ(rest[3].stamp, seconds(7));
  EXPECT_TRUE(timeline.take_due(seconds(200)).empty());
}

}  // namespace
}  // namespace castaway::sim
