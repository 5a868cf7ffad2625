#include "sim/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/sensor/lidar.hpp"
#include "tests/sim/support/frame_hash.hpp"
#include "tests/sim/support/happenings.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

std::vector<SimFrame> run(const SimulationConfig& config, unsigned seed) {
  Simulation simulation(config, test_streams(seed));
  std::vector<SimFrame> frames;
  while (auto frame = simulation.next()) frames.push_back(std::move(*frame));
  return frames;
}

template <typename Reading>
std::vector<Reading> all_of(const std::vector<SimFrame>& frames) {
  std::vector<Reading> readings;
  for (const SimFrame& frame : frames) {
    if (const auto* reading = std::get_if<Reading>(&frame.data)) readings.push_back(*reading);
  }
  return readings;
}

TEST(Simulation, DeliversEverySensorAtItsRate) {
  const auto frames = run(test_simulation(), 1);
  const auto odometry = all_of<OdometryReading>(frames);
  const auto scans = all_of<LidarReading>(frames);
  ASSERT_EQ(odometry.size(), 1000U);
  ASSERT_EQ(scans.size(), 100U);
  EXPECT_EQ(odometry[0].stamp, nanoseconds(0));
  EXPECT_EQ(odometry[7].stamp, milliseconds(70));
  EXPECT_EQ(scans[3].stamp, milliseconds(300));
  EXPECT_EQ(scans[3].ranges.size(), 360U);
}

TEST(Simulation, DeliversInOrderAndScansWithTheirLastBeam) {
  auto config = test_simulation();
  config.events.kidnaps = {{.when = {.value = 2.0}, .min_distance_m = 2.0}};
  const auto frames = run(config, 1);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    ASSERT_LE(frames[i - 1].stamp, frames[i].stamp);
    if (frames[i - 1].stamp == frames[i].stamp) {
      ASSERT_LT(frames[i - 1].data.index(), frames[i].data.index());
    }
    if (const auto* scan = std::get_if<LidarReading>(&frames[i].data)) {
      ASSERT_EQ(frames[i].stamp, scan->stamp + 359 * scan->time_increment);
    }
  }
}

TEST(Simulation, OdometryWithoutErrorsFollowsTheTruth) {
  auto config = test_simulation();
  config.duration = seconds(60);
  Simulation simulation(config, test_streams(1));
  OdometryReading last;
  while (auto frame = simulation.next()) {
    if (const auto* o = std::get_if<OdometryReading>(&frame->data)) last = *o;
  }
  const Pose2 truth = inverse(simulation.start_pose()) * last.T_map_base_true;
  EXPECT_GT(simulation.distance_driven(), 15.0);
  EXPECT_EQ(simulation.collisions(), 0);
  EXPECT_NEAR(last.T_odom_base.x, truth.x, 0.01);
  EXPECT_NEAR(last.T_odom_base.y, truth.y, 0.01);
  EXPECT_NEAR(wrap_angle(last.T_odom_base.yaw - truth.yaw), 0.0, 0.01);
}

TEST(Simulation, RepeatsToTheBit) {
  const std::uint64_t first = hash_of(run(noisy_kidnap_simulation(), 5));
  EXPECT_EQ(hash_of(run(noisy_kidnap_simulation(), 5)), first);
  EXPECT_NE(hash_of(run(noisy_kidnap_simulation(), 6)), first);
}

TEST(Simulation, AClockChangesNothing) {
  nanoseconds fake{};
  Simulation timed(noisy_kidnap_simulation(), test_streams(5),
                   [&fake] { return fake += nanoseconds(7); });
  std::vector<SimFrame> frames;
  while (auto frame = timed.next()) frames.push_back(std::move(*frame));
  EXPECT_EQ(hash_of(frames), hash_of(run(noisy_kidnap_simulation(), 5)));
  EXPECT_EQ(timed.cpu_by_stage().at("physics"), nanoseconds(7 * 7 * 715));
  EXPECT_TRUE(Simulation(noisy_kidnap_simulation(), test_streams(5)).cpu_by_stage().empty());
}

TEST(Simulation, StreamsDoNotDisturbEachOther) {
  auto config = noisy_kidnap_simulation();
  const auto with_noise = all_of<OdometryReading>(run(config, 5));
  config.lidars.front().noise.sigma = 0.0;
  const auto without = all_of<OdometryReading>(run(config, 5));
  ASSERT_EQ(with_noise.size(), without.size());
  EXPECT_EQ(with_noise.back().T_odom_base, without.back().T_odom_base);
}

TEST(Simulation, AKidnapMovesTheTruthFarAndOdometryNotAtAll) {
  const auto frames = run(noisy_kidnap_simulation(), 5);
  const auto kidnaps = all_of<KidnapRecord>(frames);
  ASSERT_EQ(kidnaps.size(), 1U);
  EXPECT_EQ(kidnaps[0].stamp, seconds(4));
  EXPECT_GE((kidnaps[0].T_map_to.position() - kidnaps[0].T_map_from.position()).norm(), 2.0);
  const auto odometry = all_of<OdometryReading>(frames);
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const auto& a = odometry[i - 1].T_odom_base;
    const auto& b = odometry[i].T_odom_base;
    ASSERT_LT(std::hypot(b.x - a.x, b.y - a.y), 0.02);
    ASSERT_LT(std::abs(wrap_angle(b.yaw - a.yaw)), 0.05);
  }
  const auto& after = odometry[400];
  ASSERT_EQ(after.stamp, seconds(4));
  EXPECT_NEAR(after.T_map_base_true.x, kidnaps[0].T_map_to.x, 1e-9);
}

/// Kidnaps of all kinds, one every four seconds, the last one with a power cycle.
SimulationConfig many_kidnaps() {
  SimulationConfig config = noisy_kidnap_simulation();
  config.duration = seconds(40);
  const std::vector<KidnapKind> kinds{KidnapKind::kNudge, KidnapKind::kTurn, KidnapKind::kLookAlike,
                                      KidnapKind::kSpin, KidnapKind::kCarry};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    config.events.kidnaps.push_back({.kind = kinds[i],
                                     .when = {.value = 8.0 + 4.0 * static_cast<double>(i)},
                                     .min_distance_m = 2.0,
                                     .lift = {.height = 0.3, .seconds = 2.0},
                                     .power_cycle = kinds[i] == KidnapKind::kCarry});
  }
  return config;
}

TEST(Simulation, DoesKidnapsOfAllKindsAndRepeatsThemToTheBit) {
  for (const DriveModel model : {DriveModel::kPhysics, DriveModel::kKinematic}) {
    SimulationConfig config = many_kidnaps();
    config.drive_model = model;
    const auto frames = run(config, 5);
    EXPECT_EQ(all_of<KidnapRecord>(frames).size(), 6U);
    EXPECT_EQ(happenings_of<PickUp>(frames).size(), 2U);
    EXPECT_EQ(hash_of(frames), hash_of(run(config, 5)));
  }
}

TEST(Simulation, ALiftedRobotIsInTheAirAndItsWheelsGoOn) {
  SimulationConfig config = test_simulation();
  config.events.kidnaps = {
      {.kind = KidnapKind::kSpin, .when = {.value = 4.0}, .lift = {.height = 0.3, .seconds = 3.0}}};
  const auto frames = run(config, 1);
  const auto kidnaps = all_of<KidnapRecord>(frames);
  ASSERT_EQ(kidnaps.size(), 1U);
  EXPECT_EQ(kidnaps[0].since, seconds(4));
  EXPECT_EQ(kidnaps[0].stamp, seconds(7));
  const auto odometry = all_of<OdometryReading>(frames);
  const Pose2 wheels = inverse(odometry[400].T_odom_base) * odometry[690].T_odom_base;
  EXPECT_GT(wheels.position().norm() + std::abs(wheels.yaw), 0.3);
  EXPECT_LT((odometry[690].T_map_base_true.position() - kidnaps[0].T_map_from.position()).norm(),
            1e-6);
}

TEST(Simulation, APowerCycleIsSilentAndOdometryBeginsAnew) {
  SimulationConfig config = test_simulation();
  config.events.kidnaps = {
      {.kind = KidnapKind::kSpin, .when = {.value = 4.0}, .power_cycle = true}};
  for (const SimFrame& frame : run(config, 1)) {
    const bool sensor = std::holds_alternative<LidarReading>(frame.data) ||
                        std::holds_alternative<OdometryReading>(frame.data);
    ASSERT_TRUE(!sensor || frame.stamp < seconds(4) || frame.stamp >= seconds(8));
    const auto* odometry = std::get_if<OdometryReading>(&frame.data);
    if (odometry != nullptr && frame.stamp == seconds(8)) {
      EXPECT_LT(odometry->T_odom_base.position().norm(), 0.02);
    }
  }
}

TEST(Simulation, ACoveredLidarSeesNothingWhileItIsCarried) {
  SimulationConfig config = test_simulation();
  config.events.kidnaps = {{.kind = KidnapKind::kSpin,
                            .when = {.value = 4.0},
                            .lift = {.seconds = 2.0, .covered = true}}};
  const auto scans = all_of<LidarReading>(run(config, 1));
  const auto seen = [](const LidarReading& scan) {
    return std::count_if(scan.ranges.begin(), scan.ranges.end(),
                         [](float range) { return std::isfinite(range); });
  };
  EXPECT_GT(seen(scans[39]), 300);
  EXPECT_EQ(seen(scans[50]), 0);
  EXPECT_GT(seen(scans[60]), 300);
}

TEST(Simulation, KidnapsOnceTheWatchedLocalizerIsRightAndSure) {
  SimulationConfig config = test_simulation();
  config.events.kidnaps = {{.when = {KidnapTrigger::On::kLocalized, 2.0}, .min_distance_m = 2.0}};
  Simulation wrong(config, test_streams(1));
  while (const auto frame = wrong.next()) {
    EXPECT_FALSE(std::holds_alternative<KidnapRecord>(frame->data));
    wrong.set_watched_pose(wrong.true_pose() * Pose2{0.6, 0.0, 0.0});
  }
  Simulation right(config, test_streams(1));
  std::optional<nanoseconds> kidnapped;
  while (const auto frame = right.next()) {
    if (std::holds_alternative<KidnapRecord>(frame->data)) kidnapped = frame->stamp;
    right.set_watched_pose(frame->stamp < seconds(3)
                               ? std::nullopt
                               : std::optional(right.true_pose() * Pose2{0.4, 0.0, 0.3}));
  }
  ASSERT_TRUE(kidnapped);
  EXPECT_GE(*kidnapped, seconds(5));
  EXPECT_LE(*kidnapped, seconds(5) + milliseconds(20));
}

TEST(Simulation, ScansFitTheWorldAtTheTruePose) {
  auto config = test_simulation();
  config.lidars.front().sweep = false;
  const auto scans = all_of<LidarReading>(run(config, 1));
  const Lidar lidar(config.lidars.front());
  const RayScene scene(ray_primitives(config.world));
  LidarDraws rng;
  for (std::size_t i = 0; i < scans.size(); i += 7) {
    for (int beam = 0; beam < 360; beam += 11) {
      const auto expected = lidar.cast(scene, to_isometry(scans[i].T_map_base_true), beam, rng);
      const float range = scans[i].ranges[static_cast<std::size_t>(beam)];
      if (std::abs(range - expected.range) < 0.01F) continue;
      // Beams that graze an edge may differ by the tiny tilt of the body.
      EXPECT_NE(scans[i].hit_object[static_cast<std::size_t>(beam)], expected.object);
    }
  }
}

}  // namespace
}  // namespace castaway::sim
