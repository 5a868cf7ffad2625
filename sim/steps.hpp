/// The stages of a step of a simulation, and what an event that is added during a run asks of them.
#pragma once

#include <array>

#include "sim/simulation_state.hpp"

namespace castaway::sim {

using SimulationState = Simulation::State;

/// @{ Events that come to be while the run goes on. They reject what is impossible as
/// `Simulation::add`.
void add(const KidnapSpec& kidnap, SimulationState& state);
void add(const FaultSpec& fault, SimulationState& state);
void add(const DriveCommand& command, SimulationState& state);
void add(const WorldChange& change, SimulationState& state);
/// @}

/// World: changes that are due take place. Nothing is put where a robot may be that is held in the
/// air.
void change_world(SimulationState& state);
/// Finds the part of the free space in which the robot is.
void find_ways(SimulationState& state);

/// Kidnaps: puts the robot elsewhere, or holds it.
void kidnap_robot(SimulationState& state);

/// Motion: of people, of what the robot is told to do, of the robot.
void take_commands(SimulationState& state);
void move_people(SimulationState& state);
void command_robot(SimulationState& state);
void move_robot(SimulationState& state);

/// Sensing: what is delivered of the step. A robot that is switched off delivers nothing.
void read_faults(SimulationState& state);
void read_odometry(SimulationState& state);
void read_further(SimulationState& state);
void read_lidars(SimulationState& state);

/// A stage of a step.
struct SimulationStage {
  void (*run)(SimulationState& state);
  const char* timed_as = nullptr;                       ///< Key of `Simulation::cpu_by_stage`.
  bool (*due)(const SimulationState& state) = nullptr;  ///< nullptr: in every step.
};

/// A step, in order.
inline constexpr std::array<SimulationStage, 10> kSimulationStages{{
    {change_world},
    {kidnap_robot},
    {take_commands},
    {move_people, "people",
     [](const SimulationState& state) { return state.people.due(state.now); }},
    {command_robot, "drive",
     [](const SimulationState& state) { return state.drive.due(state.now); }},
    {move_robot, "physics"},
    {read_faults},
    {read_odometry},
    {read_further},
    {read_lidars, "lidar"},
}};

}  // namespace castaway::sim
