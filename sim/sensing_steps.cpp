// What the robot's sensors deliver of a step.
#include <algorithm>
#include <iterator>
#include <utility>

#include "sim/steps.hpp"

namespace castaway::sim {

void add(const FaultSpec& fault, SimulationState& state) { state.sensors.add(fault); }

void read_faults(SimulationState& state) {
  for (const FaultRecord& fault : state.sensors.read_faults(state.motion)) {
    const FaultEdge edge{SensorFault{fault.kind, fault.lidar}, fault.begins};
    state.frames.push_back(
        {fault.stamp, HappeningRecord{fault.stamp, edge, fault.T_map_base_true}});
  }
}

void read_odometry(SimulationState& state) {
  const auto readings = state.sensors.read_odometry(
      state.motion, state.wheels_before, state.robot.state().wheels, state.robot.collisions());
  if (state.kidnaps.is_off()) return;
  for (const OdometryReading& reading : readings) {
    state.drive.on_odometry(reading);
    state.frames.push_back({reading.stamp, reading});
  }
}

void read_further(SimulationState& state) {
  std::vector<SimFrame> readings =
      state.sensors.read_further(state.motion, std::exchange(state.moved, false));
  if (state.kidnaps.is_off()) return;
  std::ranges::move(readings, std::back_inserter(state.frames));
}

void read_lidars(SimulationState& state) {
  state.sensors.set_covered(state.kidnaps.covered());
  std::vector<SimFrame> scans =
      state.sensors.read_lidars(state.people.around(state.sensors.scene()), state.motion);
  for (SimFrame& frame : scans) {
    auto& scan = std::get<LidarReading>(frame.data);
    const Eigen::Isometry3d T_map_base =
        to_isometry(scan.T_map_base_true) * scan.T_footprint_base_true;
    const bool levels = static_cast<bool>(state.config.levels);
    scan.people = state.people.readings(
        scan.stamp, levels ? state.plane.locate(T_map_base) : scan.T_map_base_true);
    if (state.kidnaps.is_off()) continue;
    state.drive.on_scan(scan, state.sensors.lidars()[scan.lidar]);
    state.frames.push_back(std::move(frame));
  }
}

}  // namespace castaway::sim
