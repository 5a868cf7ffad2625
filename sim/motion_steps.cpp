// Motion of people and robot.
#include <algorithm>

#include "sim/common/seconds.hpp"
#include "sim/steps.hpp"

namespace castaway::sim {

void take_commands(SimulationState& state) {
  const std::vector<DriveCommand>& commands = state.config.events.commands;
  std::size_t& next = state.next_command;
  for (; next < commands.size() && commands[next].at_s <= to_seconds(state.now); ++next) {
    state.drive.set_command(commands[next].twist);
  }
}

void add(const DriveCommand& command, SimulationState& state) {
  validate(command);
  std::vector<DriveCommand>& commands = state.config.events.commands;
  const auto to_come = commands.begin() + static_cast<std::ptrdiff_t>(state.next_command);
  commands.insert(
      std::ranges::upper_bound(to_come, commands.end(), command.at_s, {}, &DriveCommand::at_s),
      command);
}

void move_people(SimulationState& state) {
  // People walk on the lowest floor, whose chart is map; those of other floors are far from it.
  const Pose2 T_plane_base = state.T_plane_base();
  state.people.advance(state.now, T_plane_base, state.velocity, state.sensors.scene());
  for (const int person : state.people.take_hits()) {
    state.tell(Collision{Collision::Person{person}}, state.plane.in_map(T_plane_base));
  }
}

void command_robot(SimulationState& state) {
  const Pose2 T_map_base = state.T_map_base();
  state.commanded = state.drive.command(state.now, state.T_plane_base(), state.people);
  state.robot.set_command(state.commanded);
  state.progress.update({state.now, T_map_base, state.robot.touching(),
                         state.drive.wants() && !state.kidnaps.holds(),
                         state.drive.waypoints_reached()});
  for (const Driving& event : state.drive.take_events()) state.tell(event, T_map_base);
}

void move_robot(SimulationState& state) {
  const Eigen::Isometry3d before = state.robot.state().T_map_base;
  state.wheels_before = state.robot.state().wheels;
  if (state.kidnaps.holds()) {
    state.robot.step_held(state.kidnaps.held_at(state.now + state.step), state.kidnaps.wheels());
  } else {
    state.robot.step();
  }
  const Eigen::Isometry3d& after = state.robot.state().T_map_base;
  state.motion = {state.now, state.now + state.step, before, after};
  const Eigen::Vector2d way = (after.translation() - before.translation()).head<2>();
  if (!state.kidnaps.holds()) state.distance += way.norm();
  state.velocity = way / to_seconds(state.step);
}

}  // namespace castaway::sim
