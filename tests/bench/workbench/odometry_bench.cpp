#include "tests/bench/workbench/odometry_bench.hpp"

#include "castaway/stamp.hpp"
#include "sim/sensor/odometry_profiles.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"

namespace castaway::testbed {
namespace {

Frames drive(const std::string& profile, std::uint64_t seed, double duration_s) {
  Scenario scenario;
  scenario.seed = seed;
  scenario.duration_s = duration_s;
  scenario.odometry = sim::odometry_profile(profile).value();
  scenario.lidars.front().set("beams", 1).set("rate_hz", 1.0);  // The scans are not used.
  PreparedSimulation prepared = build_simulation(scenario, ".");
  std::vector<sim::LidarConfig> lidars = prepared.config.lidars;
  SimulatorSource source(
      sim::Simulation(std::move(prepared.config), simulation_streams(scenario.seed)),
      std::move(lidars), localization::from_seconds(duration_s));
  Frames frames;
  while (auto frame = source.next()) frames.push_back(std::move(*frame));
  return frames;
}

}  // namespace

std::vector<DriftSegment> simulated_drift(const std::string& profile,
                                          const OdometryBenchConfig& config) {
  std::vector<DriftSegment> all;
  for (int seed = 1; seed <= config.seeds; ++seed) {
    const Frames frames = drive(profile, static_cast<std::uint64_t>(seed), config.duration_s);
    const auto segments = drift_segments(frames, config.length_m);
    all.insert(all.end(), segments.begin(), segments.end());
  }
  return all;
}

}  // namespace castaway::testbed
