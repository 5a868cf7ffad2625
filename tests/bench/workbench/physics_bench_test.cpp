#include "tests/bench/workbench/physics_bench.hpp"

#include <map>

#include <gtest/gtest.h>

#include "tools/build/build_robot.hpp"

namespace castaway::testbed {
namespace {

class PhysicsBench : public testing::TestWithParam<const char*> {};

/// Tolerances are millimetres and milliradians over metres and turns.
TEST_P(PhysicsBench, AgreesWithMechanics) {
  RobotSpec spec;
  spec.file = GetParam();
  const std::map<std::string, double> tolerance{
      {"m", 0.006}, {"rad", 0.01}, {"m/s", 0.003}, {"deg", 0.3}};
  const auto checks = check_physics(build_robot(spec, "."), 500.0);
  EXPECT_EQ(checks.size(), 9U);
  for (const PhysicsCheck& check : checks) {
    EXPECT_NEAR(check.measured, check.expected, tolerance.at(check.unit)) << check.what;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, PhysicsBench, testing::Values("waffle", "disc"));

}  // namespace
}  // namespace castaway::testbed
