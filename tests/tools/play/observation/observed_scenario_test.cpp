#include "tools/play/observation/observed_scenario.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(ObservedScenario, IsAScenarioOrTheRobotOfAWorld) {
  EXPECT_EQ(observed_scenario("hillside/drive", {}).loaded.scenario.name, "hillside-drive");
  const Scenario flat = observed_scenario("hall", {}).loaded.scenario;
  EXPECT_EQ(flat.world.file, "hall");
  EXPECT_EQ(flat.robot.file, "waffle");
  const Scenario slope = observed_scenario("hillside", {"seed=7"}).loaded.scenario;
  EXPECT_EQ(slope.robot.file, "mule");
  EXPECT_EQ(slope.lidars.front().profile, "vlp-16");
  EXPECT_EQ(slope.seed, 7U);
  EXPECT_EQ(observed_scenario("hall", {"robot=mule"}).loaded.scenario.robot.file, "mule");
  EXPECT_THROW(observed_scenario("nowhere", {}), std::runtime_error);
}

}  // namespace
}  // namespace castaway::testbed
