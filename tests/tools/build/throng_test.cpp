/// A robot driven by the truth among people who do not yield.

#include <algorithm>

#include <gtest/gtest.h>

#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"

namespace castaway::testbed {
namespace {

struct Progress {
  double distance = 0.0;     // [m]
  double longest_stand = 0;  // [s]
};

Progress progress_among(int people, std::uint64_t seed) {
  sim::SimulationConfig config = build_simulation({}, ".").config;
  config.people.walking = people;
  config.drive_model = sim::DriveModel::kKinematic;
  config.physics_hz = 100.0;
  config.duration = std::chrono::minutes(10);
  sim::Simulation simulation(config, simulation_streams(seed));
  Progress progress;
  Eigen::Vector2d last = config.start.position();
  double still = 0.0;
  while (const auto frame = simulation.next()) {
    const auto* scan = std::get_if<sim::LidarReading>(&frame->data);
    if (scan == nullptr) continue;
    const double way = (scan->T_map_base_true.position() - last).norm();
    last = scan->T_map_base_true.position();
    progress.distance += way;
    still = way > 1e-3 ? 0.0 : still + 1.0 / config.lidars.front().rate_hz;
    progress.longest_stand = std::max(progress.longest_stand, still);
  }
  return progress;
}

TEST(Throng, HoldsNobodyUpForGood) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Progress progress = progress_among(8, seed);
    EXPECT_GT(progress.distance, 60.0) << seed;
    EXPECT_LT(progress.longest_stand, 90.0) << seed;
  }
}

TEST(Throng, OfTwentyInALaboratoryIsPassedInTheEnd) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Progress progress = progress_among(20, seed);
    EXPECT_GT(progress.distance, 30.0) << seed;
    EXPECT_LT(progress.longest_stand, 180.0) << seed;
  }
}

}  // namespace
}  // namespace castaway::testbed
