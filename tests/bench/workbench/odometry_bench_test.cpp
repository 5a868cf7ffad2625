#include "tests/bench/workbench/odometry_bench.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(OdometryBench, ProfilesDriftInTheirOrder) {
  const OdometryBenchConfig config{2, 40.0, 3.0};
  double before = -1.0;
  for (const std::string profile : {"ideal", "new-wheels", "worn-wheels", "slippery"}) {
    const auto drift = mean_drift(simulated_drift(profile, config));
    ASSERT_TRUE(drift.has_value());
    EXPECT_GT(drift->deg_per_m, before) << profile;
    before = drift->deg_per_m;
  }
}

}  // namespace
}  // namespace castaway::testbed
