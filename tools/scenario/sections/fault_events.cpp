#include "tools/scenario/sections/fault_events.hpp"

#include <numbers>

namespace castaway::testbed {
namespace {

using sim::FaultKind;

void blocked_fields(Settings& settings, sim::FaultSpec& fault) {
  settings.field(
      {"from_deg", "deg", "lidar-blocked: first angle of the blocked sector.", {-360.0, 360.0}},
      fault.from_deg);
  settings.field(
      {"to_deg", "deg", "lidar-blocked: last angle of the blocked sector.", {-360.0, 360.0}},
      fault.to_deg);
  settings.field({"distance_m", "m", "lidar-blocked: range of the cover.", {0.001, 100.0}},
                 fault.distance);
}

void mount_fields(Settings& settings, sim::FaultSpec& fault) {
  double yaw_deg = 0.0;
  settings.field({"dx_m", "m", "lidar-mount: error of the nominal mount along x.", {-10.0, 10.0}},
                 fault.mount_error.x);
  settings.field({"dy_m", "m", "lidar-mount: error of the nominal mount along y.", {-10.0, 10.0}},
                 fault.mount_error.y);
  settings.field(
      {"yaw_deg", "deg", "lidar-mount: error of the nominal mount in yaw.", {-180.0, 180.0}},
      yaw_deg);
  fault.mount_error.yaw = yaw_deg * std::numbers::pi / 180.0;
  if (!settings.describes() && fault.mount_error == sim::Pose2{}) {
    settings.fail("a mount without an error: give 'dx_m', 'dy_m' or 'yaw_deg'");
  }
}

void kind_fields(Settings& settings, sim::FaultSpec& fault) {
  const auto is = [&](FaultKind kind) { return settings.describes() || fault.kind == kind; };
  if (is(FaultKind::kLidarBlocked)) blocked_fields(settings, fault);
  if (is(FaultKind::kLidarMount)) mount_fields(settings, fault);
  if (is(FaultKind::kLidarLate)) {
    settings.field({"delay_s", "s", "lidar-late: delay of each scan.", {0.001, 10.0}},
                   fault.delay_s);
  }
  if (is(FaultKind::kLidarClock)) {
    settings.field({"offset_s",
                    "s",
                    "lidar-clock: offset of the stamps; positive if the clock is fast.",
                    {-10.0, 10.0}},
                   fault.offset_s);
  }
  if (is(FaultKind::kOdometryScale)) {
    settings.field({"scale", "", "odometry-scale: factor of the wheels' counts.", {0.01, 10.0}},
                   fault.scale);
  }
  if (is(FaultKind::kOdometryReversed)) {
    settings.choice({"wheel", "", "odometry-reversed: the wheel that counts backwards."},
                    fault.reverse_right, {{"left", false}, {"right", true}});
  }
}

std::vector<std::pair<std::string, FaultKind>> fault_kinds() {
  std::vector<std::pair<std::string, FaultKind>> kinds;
  for (const char* name : sim::kFaultNames) {
    kinds.emplace_back(name, static_cast<FaultKind>(kinds.size()));
  }
  return kinds;
}

}  // namespace

void fields(Settings settings, sim::FaultSpec& fault) {
  settings.choice({"kind", "", "What goes wrong."}, fault.kind, fault_kinds());
  settings.field({"at_s", "s", "Start of the fault.", {0.0, 1e6}}, fault.at_s);
  if (fault.kind != FaultKind::kOdometryReset) {
    settings.field({"for_s", "s", "Duration of the fault.", {0.001, 1e6}}, fault.for_s);
  }
  if (sim::is_lidar_fault(fault.kind) && settings.has("lidar")) {
    settings.field({"lidar", "", "Name of the lidar; by default, all of them."}, fault.lidar);
  }
  kind_fields(settings, fault);
}

sim::FaultSpec read_fault(YamlReader body) {
  (void)body.require<std::string>("kind");
  (void)body.require<double>("at_s");
  sim::FaultSpec fault;
  Settings::reading(body).choice({"kind", "", ""}, fault.kind, fault_kinds());
  if (fault.kind != FaultKind::kOdometryReset) (void)body.require<double>("for_s");
  fields(Settings::reading(body), fault);
  return fault;
}

}  // namespace castaway::testbed
