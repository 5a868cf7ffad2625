// Changes of the world while the robot drives.
#include <utility>

#include "sim/stages/drive_space.hpp"
#include "sim/steps.hpp"

namespace castaway::sim {
namespace {

/// True if no robot or person is where something solid or somebody comes.
bool has_room(const WorldChange& change, const SimulationState& state) {
  if (const auto* arrival = std::get_if<AddPeople>(&change.what)) {
    return state.people.has_room(*arrival, state.T_map_base(), state.config, *state.spaces);
  }
  const std::optional<WorldObject> solid = solid_of(change, state.config.world);
  if (!solid) return true;
  const Occupants occupants{state.T_map_base().position(), state.config.robot.footprint_radius,
                            state.people.positions()};
  return is_clear(*solid, occupants, state.config.map.resolution);
}

void take_new_world(SimulationState& state) {
  state.changed = true;
  state.spaces = std::make_shared<Spaces>(WalkParts::kAll);
  state.robot.set_objects(state.config.world);
  state.sensors.set_world(state.config.world);
  state.kidnaps.set_world(state.config, *state.spaces);
  if (state.people.people() != nullptr) {
    state.people.set_cells(state.spaces->walking(state.config.world, state.config.map));
  }
  find_ways(state);
}

bool make(const WorldChange& change, SimulationState& state) {
  if (!has_room(change, state)) return false;
  const Pose2 T_map_base = state.T_map_base();
  WorldNews news = news_of(change, state.config.world);
  if (const auto* arrival = std::get_if<AddPeople>(&change.what)) {
    state.people.add(*arrival, state.now, T_map_base, state.config, *state.spaces);
  } else {
    apply(change, state.config.world);
    take_new_world(state);
  }
  state.noted.push_back({state.now, HappeningRecord{state.now, std::move(news), T_map_base}});
  return true;
}

void make_due_changes(SimulationState& state) {
  if (state.kidnaps.holds() || !state.changes.due(state.now)) return;
  state.changes.advance(state.now, [&](const WorldChange& change) { return make(change, state); });
}

}  // namespace

void find_ways(SimulationState& state) {
  const Eigen::Vector2d p_map = state.T_map_base().position();
  const auto part = [&](double radius) {
    return state.spaces->driving_around(state.config, radius, p_map);
  };
  state.robot.set_free([&] { return part(standing_radius(state.config)); });
  if (!state.config.drive.by_estimate) {
    state.drive.set_free(part(state.config.robot.footprint_radius + kDriveMargin));
  }
}

void change_world(SimulationState& state) {
  make_due_changes(state);
  std::ranges::move(state.noted, std::back_inserter(state.frames));
  state.noted.clear();
}

void add(const WorldChange& change, SimulationState& state) {
  validate(change);
  if (state.config.levels) {
    throw std::invalid_argument("a world with `levels: true` cannot change yet");
  }
  if (!has_room(change, state)) {
    throw std::invalid_argument("there is no room: robot or people are in the way");
  }
  state.changes.add(change, state.config.world);
  make_due_changes(state);  // As the next step would: what is added next must have room beside it.
}

}  // namespace castaway::sim
