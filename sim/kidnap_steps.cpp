// Kidnaps of the robot, from its triggers to where it stands.
#include <cmath>

#include "sim/steps.hpp"

namespace castaway::sim {
namespace {

/// True while the watched output is right.
bool localized(const SimulationState& state) {
  if (!state.watched) return false;
  const SimulationConfig& config = state.config;
  const Pose2 error = inverse(state.T_map_base()) * *state.watched;
  const double z = state.robot.state().T_map_base.translation().z();
  const double above = state.plane.levels() != nullptr ? state.watched_z - z : 0.0;
  return std::hypot(error.position().norm(), above) < config.right_position &&
         std::abs(error.yaw) < config.right_yaw;
}

/// Takes the record's poses in frame plane.
void teleport(KidnapRecord record, SimulationState& state) {
  const PlaneTracker& plane = state.plane;
  state.people.on_kidnap(record.T_map_to);
  state.moved = true;
  if (plane.levels() != nullptr) {
    state.robot.place(plane.standing_at(record.T_map_to));
    record.z_from = plane.height_at(record.T_map_from);
    record.z_to = plane.height_at(record.T_map_to);
    record.T_map_from = plane.in_map(record.T_map_from);
    record.T_map_to = plane.in_map(record.T_map_to);
  } else {
    state.robot.teleport(record.T_map_to);
  }
  if (state.changed) find_ways(state);
  state.progress.on_teleport();
  state.frames.push_back({state.now, record});
}

void kidnap_on_request(SimulationState& state) {
  if (!state.requested) return;
  teleport({state.now, KidnapKind::kTeleportTo, state.T_plane_base(), *state.requested, state.now},
           state);
  state.requested.reset();
}

}  // namespace

void kidnap_robot(SimulationState& state) {
  const auto positions = [&] { return state.people.positions(); };
  const Pose2 from = state.T_plane_base();
  const KidnapOutcome outcome = state.kidnaps.advance(
      {state.now, from, state.distance, localized(state), positions}, state.streams.events);
  if (outcome.done) {
    teleport(*outcome.done, state);
    if (state.kidnaps.was_power_cycle()) state.sensors.reset_odometry();
  }
  if (outcome.picked_up) state.tell(*outcome.picked_up, state.plane.in_map(from));
  if (!state.kidnaps.holds()) kidnap_on_request(state);
}

void add(const KidnapSpec& kidnap, SimulationState& state) {
  state.kidnaps.add(kidnap, state.T_plane_base());
}

}  // namespace castaway::sim
