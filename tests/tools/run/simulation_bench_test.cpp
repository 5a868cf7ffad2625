#include "tools/campaign/simulation_bench.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(SimulationBench, TellsWhatTheStagesTake) {
  const SimulationCost cost = time_simulation({3, 90, 0, 2.0});
  EXPECT_GT(cost.realtime_factor, 1.0);
  EXPECT_GT(cost.cpu_s.at("people"), 0.0);
  EXPECT_GT(cost.cpu_s.at("physics"), cost.cpu_s.at("people"));
}

TEST(SimulationBench, RunsInAHallOfBoxes) {
  EXPECT_GT(time_simulation({0, 90, 60, 2.0}).realtime_factor, 1.0);
}

TEST(SimulationBench, CastsFasterThanALoop) {
  const CastSpeed speed = time_casts(920, 20, 0.05);
  EXPECT_GT(speed.rays_per_s, 3.0 * speed.plain_rays_per_s);
}

}  // namespace
}  // namespace castaway::testbed
