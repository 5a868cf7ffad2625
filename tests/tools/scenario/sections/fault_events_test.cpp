#include "tools/scenario/sections/fault_events.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

sim::FaultSpec fault_of(const std::string& body) {
  YamlDocument document = YamlDocument::parse("fault: " + body, "scenario.yaml");
  YamlReader root = document.root();
  const sim::FaultSpec fault = read_fault(root.child("fault"));
  document.reject_unknown_keys();
  return fault;
}

std::string fault_error(const std::string& body) {
  try {
    (void)fault_of(body);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(FaultEvents, ReadWhatTheirKindNeeds) {
  const sim::FaultSpec blocked = fault_of(
      "{kind: lidar-blocked, at_s: 3, for_s: 4, lidar: front, from_deg: -10, to_deg: 20, "
      "distance_m: 0.3}");
  EXPECT_EQ(blocked.kind, sim::FaultKind::kLidarBlocked);
  EXPECT_EQ(blocked.at_s, 3.0);
  EXPECT_EQ(blocked.for_s, 4.0);
  EXPECT_EQ(blocked.lidar, "front");
  EXPECT_EQ(blocked.from_deg, -10.0);
  EXPECT_EQ(blocked.to_deg, 20.0);
  EXPECT_EQ(blocked.distance, 0.3);
  const sim::FaultSpec mount =
      fault_of("{kind: lidar-mount, at_s: 3, for_s: 4, dx_m: 0.1, dy_m: -0.2, yaw_deg: 90}");
  EXPECT_EQ(mount.mount_error, (sim::Pose2{0.1, -0.2, std::numbers::pi / 2}));
  EXPECT_EQ(fault_of("{kind: lidar-late, at_s: 3, for_s: 4, delay_s: 0.7}").delay_s, 0.7);
  EXPECT_EQ(fault_of("{kind: lidar-clock, at_s: 3, for_s: 4, offset_s: -0.7}").offset_s, -0.7);
  EXPECT_EQ(fault_of("{kind: odometry-scale, at_s: 3, for_s: 4, scale: 1.5}").scale, 1.5);
  EXPECT_FALSE(fault_of("{kind: odometry-reversed, at_s: 3, for_s: 4, wheel: left}").reverse_right);
  EXPECT_EQ(fault_of("{kind: odometry-reset, at_s: 3}").kind, sim::FaultKind::kOdometryReset);
}

TEST(FaultEvents, EveryKindIsKnown) {
  for (const std::string name : sim::kFaultNames) {
    const std::string more = name == "odometry-reset" ? "" : ", for_s: 1";
    const std::string error = name == "lidar-mount" ? ", dx_m: 0.1" : "";
    EXPECT_EQ(sim::to_string(fault_of("{kind: " + name + ", at_s: 1" + more + error + "}").kind),
              name);
  }
}

TEST(FaultEvents, SayWhatIsWrong) {
  EXPECT_THAT(fault_error("{kind: lidar-droput, at_s: 1, for_s: 1}"), HasSubstr("'lidar-dropout'"));
  EXPECT_THAT(fault_error("{at_s: 1, for_s: 1}"), HasSubstr("needs the key 'kind'"));
  EXPECT_THAT(fault_error("{kind: lidar-late, for_s: 1}"), HasSubstr("needs the key 'at_s'"));
  EXPECT_THAT(fault_error("{kind: lidar-late, at_s: 1}"), HasSubstr("needs the key 'for_s'"));
  EXPECT_THAT(
      fault_error("{kind: lidar-late, at_s: -1, for_s: 1}"),
      HasSubstr("scenario.yaml:1: fault.at_s: -1 is out of range; give from 0 to 1000000 s"));
  EXPECT_THAT(fault_error("{kind: lidar-late, at_s: 1, for_s: 1, scale: 2}"), HasSubstr("scale"));
  EXPECT_THAT(fault_error("{kind: odometry-frozen, at_s: 1, for_s: 1, lidar: front}"),
              HasSubstr("lidar"));
  EXPECT_THAT(fault_error("{kind: lidar-mount, at_s: 1, for_s: 1}"), HasSubstr("dx_m"));
}

}  // namespace
}  // namespace castaway::testbed
