#include <chrono>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/simulation.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::seconds;

TEST(SimulationDrive, DrivesOnAfterAKidnapWithoutHittingAnything) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    auto config = noisy_kidnap_simulation();
    config.random_start = true;
    config.duration = seconds(60);
    config.events.kidnaps.push_back({.when = {.value = 20.0}, .min_distance_m = 1.0});
    Simulation simulation(config, test_streams(seed));
    while (simulation.next()) {
    }
    EXPECT_EQ(simulation.collisions(), 0) << seed;
    EXPECT_GT(simulation.distance_driven(), 12.0) << seed;
  }
}

TEST(SimulationDrive, StandsStillWithoutWaypointsOrWithoutAnEstimate) {
  auto config = test_simulation();
  config.drive.by_estimate = true;
  Simulation waiting(config, test_streams(1));
  while (waiting.next()) {
  }
  EXPECT_LT(waiting.distance_driven(), 0.01);
  config.drive.by_estimate = false;
  config.drive.waypoints.clear();
  Simulation parked(config, test_streams(1));
  while (parked.next()) {
  }
  EXPECT_LT(parked.distance_driven(), 0.01);
}

TEST(SimulationDrive, DrivesByTheEstimateItIsGiven) {
  auto config = test_simulation();
  config.drive.by_estimate = true;
  Simulation simulation(config, test_streams(1));
  while (simulation.next()) simulation.set_drive_pose(simulation.true_pose());
  EXPECT_GT(simulation.distance_driven(), 2.0);
}

TEST(SimulationDrive, AWrongEstimateDrivesItAboutButIntoNothing) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    auto config = test_simulation();
    config.drive.by_estimate = true;
    config.random_start = true;
    config.duration = seconds(60);
    Simulation simulation(config, test_streams(seed));
    while (simulation.next()) {
      const Pose2 truth = simulation.true_pose();
      simulation.set_drive_pose(Pose2{-truth.x, -truth.y, truth.yaw + 2.0});
    }
    EXPECT_EQ(simulation.collisions(), 0) << seed;
    EXPECT_GT(simulation.distance_driven(), 2.0) << seed;
  }
}

TEST(SimulationDrive, AvoidsWhatIsNotOnTheMap) {
  auto config = test_simulation();
  config.duration = seconds(40);
  WorldObject crate = box_on_floor("crate", {0.5, 0.5, 0.4}, {0.7, -2.0});
  crate.in_map = false;
  config.world.objects.push_back(crate);
  Simulation simulation(config, test_streams(1));
  while (simulation.next()) {
  }
  EXPECT_EQ(simulation.collisions(), 0);
  EXPECT_GT(simulation.distance_driven(), 10.0);
}

std::string error_of(const SimulationConfig& config) {
  try {
    Simulation simulation(config, test_streams(1));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(SimulationErrors, RefusesAStartInAWall) {
  auto config = test_simulation();
  config.start = {0.3, 0.2, 0.0};
  EXPECT_THAT(error_of(config), testing::HasSubstr("start: at (0.3, 0.2)"));
}

TEST(SimulationErrors, RefusesAKidnapIntoTheTableFromTheStart) {
  auto config = test_simulation();
  config.events.kidnaps = {
      {.kind = KidnapKind::kTeleportTo, .when = {.value = 9.0}, .target = Pose2{0.3, 0.2, 0.0}}};
  EXPECT_THAT(error_of(config), testing::HasSubstr("kidnap at 9 s"));
}

TEST(SimulationErrors, RefusesToRunWithoutAMap) {
  auto config = test_simulation();
  config.map = {};
  EXPECT_THAT(error_of(config), testing::HasSubstr("map"));
}

/// Steps to this time.
void drive_until(Simulation& simulation, std::chrono::nanoseconds end) {
  while (const auto frame = simulation.next()) {
    if (frame->stamp >= end) return;
  }
}

TEST(SimulationDrive, IsDrivenByCommandsInPlaceOfItsRoute) {
  Simulation simulation(test_simulation(), test_streams(1));
  simulation.set_command(Twist2{0.0, 0.5});
  drive_until(simulation, seconds(2));
  EXPECT_LT((simulation.true_pose().position() - simulation.start_pose().position()).norm(), 0.05);
  EXPECT_NEAR(simulation.true_pose().yaw - simulation.start_pose().yaw, 1.0, 0.2);
  simulation.set_command(std::nullopt);
  drive_until(simulation, seconds(6));
  EXPECT_GT(simulation.distance_driven(), 0.3);
}

TEST(SimulationDrive, ACommandedRobotThatStandsIsNotStuck) {
  auto config = test_simulation();
  config.duration = seconds(60);
  Simulation simulation(config, test_streams(1));
  simulation.set_command(Twist2{});
  while (simulation.next()) {
  }
  EXPECT_LT(simulation.distance_driven(), 0.01);
  EXPECT_FALSE(simulation.void_record().has_value());
}

TEST(SimulationDrive, IsKidnappedOnRequest) {
  Simulation simulation(test_simulation(), test_streams(1));
  simulation.set_command(Twist2{});
  drive_until(simulation, seconds(1));
  const Pose2 start = simulation.start_pose();
  const Pose2 target{start.x, start.y, start.yaw + 1.5};
  simulation.kidnap(target);
  std::optional<KidnapRecord> record;
  while (const auto frame = simulation.next()) {
    if (const auto* found = std::get_if<KidnapRecord>(&frame->data)) record = *found;
    if (frame->stamp >= seconds(2)) break;
  }
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->T_map_to, target);
  EXPECT_NEAR(simulation.true_pose().yaw, wrap_angle(target.yaw), 0.02);
  EXPECT_LT(simulation.distance_driven(), 0.05);
}

TEST(SimulationDrive, IsNotKidnappedIntoAWall) {
  Simulation simulation(test_simulation(), test_streams(1));
  EXPECT_THROW(simulation.kidnap({1e3, 0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::sim
