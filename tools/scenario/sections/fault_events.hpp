/// Faults of sensors among the events of a scenario.
#pragma once

#include "sim/events/fault.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads the body of a `fault`:
///
///     - fault: {kind: lidar-dropout, at_s: 10, for_s: 5, lidar: front}
///     - fault: {kind: lidar-frozen, at_s: 10, for_s: 5}
///     - fault: {kind: lidar-blocked, at_s: 10, for_s: 5, from_deg: -30, to_deg: 30, distance_m:
///     0.2}
///     - fault: {kind: lidar-mount, at_s: 10, for_s: 5, dx_m: 0.05, dy_m: 0, yaw_deg: 3}
///     - fault: {kind: lidar-late, at_s: 10, for_s: 5, delay_s: 0.3}
///     - fault: {kind: lidar-clock, at_s: 10, for_s: 5, offset_s: 0.2}
///     - fault: {kind: odometry-frozen, at_s: 10, for_s: 5}
///     - fault: {kind: odometry-scale, at_s: 10, for_s: 5, scale: 1.2}
///     - fault: {kind: odometry-reversed, at_s: 10, for_s: 5, wheel: left}
///     - fault: {kind: odometry-dropout, at_s: 10, for_s: 5}
///     - fault: {kind: odometry-reset, at_s: 10}
///
/// Without `lidar`, faults of lidars mean all of them. Faults may overlap.
sim::FaultSpec read_fault(YamlReader body);

}  // namespace castaway::testbed
