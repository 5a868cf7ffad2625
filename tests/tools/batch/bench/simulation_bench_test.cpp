#include "tools/batch/bench/simulation_bench.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

// The benchmark itself measures the speed; this test only checks that it measured something.

TEST(SimulationBench, TellsWhatEveryStageTakes) {
  const SimulationCost cost = time_simulation({3, 90, 0, 2.0, false});
  EXPECT_GT(cost.realtime_factor, 0.0);
  for (const char* stage : {"physics", "lidar", "people"}) {
    ASSERT_TRUE(cost.cpu_s.contains(stage)) << stage;
    EXPECT_GT(cost.cpu_s.at(stage), 0.0) << stage;
  }
}

TEST(SimulationBench, RunsInAHallOfBoxes) {
  const SimulationCost cost = time_simulation({0, 90, 60, 2.0, false});
  EXPECT_GT(cost.realtime_factor, 0.0);
}

TEST(SimulationBench, RunsWithoutPhysics) {
  const SimulationCost cost = time_simulation({0, 90, 0, 2.0, true});
  EXPECT_TRUE(cost.spec.kinematic);
  EXPECT_GT(cost.realtime_factor, 0.0);
}

TEST(SimulationBench, CountsRaysOfBothCasters) {
  const CastSpeed speed = time_casts(920, 20, 0.05);
  EXPECT_GT(speed.rays_per_s, 0.0);
  EXPECT_GT(speed.plain_rays_per_s, 0.0);
}

}  // namespace
}  // namespace castaway::testbed
