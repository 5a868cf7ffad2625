// Events that are added to a run while it goes on.
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/common/seconds.hpp"
#include "sim/simulation.hpp"
#include "tests/sim/support/frame_hash.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

SimulationConfig open_simulation() {
  SimulationConfig config = test_simulation();
  config.open = true;
  return config;
}

std::uint64_t played(SimulationConfig config) {
  Simulation simulation(std::move(config), test_streams(3));
  std::vector<SimFrame> frames;
  while (auto frame = simulation.next()) frames.push_back(std::move(*frame));
  return hash_of(frames);
}

/// Plays until `at_s`, then calls `add(simulation)`, and plays on.
template <typename Add>
std::uint64_t played_with(double at_s, Add add) {
  Simulation simulation(open_simulation(), test_streams(3));
  std::vector<SimFrame> frames;
  bool added = false;
  while (auto frame = simulation.next()) {
    frames.push_back(std::move(*frame));
    if (added || to_seconds(simulation.now()) < at_s) continue;
    add(simulation);
    added = true;
  }
  return hash_of(frames);
}

TEST(OpenSimulation, WithoutEventsEqualsOneThatIsNot) {
  EXPECT_EQ(played(open_simulation()), played(test_simulation()));
}

TEST(OpenSimulation, AKidnapThatIsAddedEqualsOneThatIsConfigured) {
  for (const KidnapKind kind :
       {KidnapKind::kTeleportRandom, KidnapKind::kTurn, KidnapKind::kSpin, KidnapKind::kCarry}) {
    SimulationConfig config = test_simulation();
    const auto kidnap_at = [kind](double at_s) {
      KidnapSpec kidnap;
      kidnap.kind = kind;
      kidnap.when.value = at_s;
      kidnap.min_distance_m = 1.0;
      kidnap.lift.seconds = 0.2;
      return kidnap;
    };
    double at_s = 0.0;
    const std::uint64_t added = played_with(2.0, [&](Simulation& simulation) {
      at_s = to_seconds(simulation.now());
      simulation.add(kidnap_at(at_s));
      simulation.add(kidnap_at(at_s + 1.0));
    });
    config.events.kidnaps = {kidnap_at(at_s), kidnap_at(at_s + 1.0)};
    EXPECT_EQ(added, played(config)) << static_cast<int>(kind);
    EXPECT_NE(added, played(open_simulation())) << static_cast<int>(kind);
  }
}

TEST(OpenSimulation, AFaultThatIsAddedEqualsOneThatIsConfigured) {
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    SimulationConfig config = test_simulation();
    FaultSpec fault;
    fault.kind = static_cast<FaultKind>(i);
    fault.mount_error = {0.1, 0.0, 0.0};
    const std::uint64_t added = played_with(2.0, [&](Simulation& simulation) {
      fault.at_s = to_seconds(simulation.now());
      simulation.add(fault);
    });
    config.events.faults = {fault};
    EXPECT_EQ(added, played(config)) << to_string(fault.kind);
    EXPECT_NE(added, played(open_simulation())) << to_string(fault.kind);
  }
}

TEST(OpenSimulation, ACommandThatIsAddedEqualsOneThatIsConfigured) {
  SimulationConfig config = test_simulation();
  const std::uint64_t added = played_with(2.0, [&](Simulation& simulation) {
    const double now_s = to_seconds(simulation.now());
    config.events.commands = {{now_s, Twist2{0.1, 0.5}}, {now_s + 2.0, std::nullopt}};
    simulation.add(config.events.commands[1]);
    simulation.add(config.events.commands[0]);
  });
  EXPECT_EQ(added, played(config));
  EXPECT_NE(added, played(open_simulation()));
}

TEST(OpenSimulation, RefusesWhatIsImpossible) {
  Simulation simulation(open_simulation(), test_streams(3));
  KidnapSpec into_a_wall;
  into_a_wall.kind = KidnapKind::kTeleportTo;
  into_a_wall.target = Pose2{1e3, 0.0, 0.0};
  EXPECT_THROW(simulation.add(into_a_wall), std::runtime_error);
  FaultSpec fault;
  fault.for_s = -1.0;
  EXPECT_THROW(simulation.add(fault), std::invalid_argument);
  EXPECT_THROW(simulation.add(DriveCommand{-1.0, std::nullopt}), std::invalid_argument);
  Simulation closed(test_simulation(), test_streams(3));
  EXPECT_THROW(closed.add(DriveCommand{}), std::logic_error);
}

}  // namespace
}  // namespace castaway::sim
