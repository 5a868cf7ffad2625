#include "tools/scenario/sections/fault_events.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

using sim::FaultKind;

/// Values that a key may have.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

double within(YamlReader& body, const std::string& key, double fallback, const Bounds& bounds) {
  const double value = body.get(key, fallback);
  if (value >= bounds.low && value <= bounds.high) return value;
  body.find(key)->fail(
      fmt::format("'{}' is {}: give {} to {}", key, value, bounds.low, bounds.high));
}

void read_blocked(YamlReader& body, sim::FaultSpec& fault) {
  fault.from_deg = within(body, "from_deg", fault.from_deg, {-360.0, 360.0});
  fault.to_deg = within(body, "to_deg", fault.to_deg, {-360.0, 360.0});
  fault.distance = within(body, "distance_m", fault.distance, {0.001, 100.0});
}

void read_mount(YamlReader& body, sim::FaultSpec& fault) {
  fault.mount_error.x = within(body, "dx_m", 0.0, {-10.0, 10.0});
  fault.mount_error.y = within(body, "dy_m", 0.0, {-10.0, 10.0});
  const double yaw_deg = within(body, "yaw_deg", 0.0, {-180.0, 180.0});
  fault.mount_error.yaw = yaw_deg * std::numbers::pi / 180.0;
  if (fault.mount_error == sim::Pose2{}) {
    body.fail("a mount without an error: give 'dx_m', 'dy_m' or 'yaw_deg'");
  }
}

void read_figures(YamlReader& body, sim::FaultSpec& fault) {
  if (fault.kind == FaultKind::kLidarBlocked) read_blocked(body, fault);
  if (fault.kind == FaultKind::kLidarMount) read_mount(body, fault);
  if (fault.kind == FaultKind::kLidarLate) {
    fault.delay_s = within(body, "delay_s", fault.delay_s, {0.001, 10.0});
  }
  if (fault.kind == FaultKind::kLidarClock) {
    fault.offset_s = within(body, "offset_s", fault.offset_s, {-10.0, 10.0});
  }
  if (fault.kind == FaultKind::kOdometryScale) {
    fault.scale = within(body, "scale", fault.scale, {0.01, 10.0});
  }
  if (fault.kind == FaultKind::kOdometryReversed) {
    fault.reverse_right = body.choice("wheel", "right", {"left", "right"}) == "right";
  }
}

}  // namespace

sim::FaultSpec read_fault(YamlReader body) {
  const std::vector<std::string> names(sim::kFaultNames.begin(), sim::kFaultNames.end());
  (void)body.require<std::string>("kind");
  const std::string kind = body.choice("kind", "", names);
  sim::FaultSpec fault;
  const auto found = std::find(names.begin(), names.end(), kind);
  fault.kind = static_cast<FaultKind>(found - names.begin());
  (void)body.require<double>("at_s");
  fault.at_s = within(body, "at_s", 0.0, {0.0, 1e6});
  if (fault.kind != FaultKind::kOdometryReset) {
    (void)body.require<double>("for_s");
    fault.for_s = within(body, "for_s", 1.0, {0.001, 1e6});
  }
  if (sim::is_lidar_fault(fault.kind) && body.has("lidar")) {
    fault.lidar = body.require<std::string>("lidar");
  }
  read_figures(body, fault);
  return fault;
}

}  // namespace castaway::testbed
