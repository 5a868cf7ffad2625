#include "sim/stages/people_stage.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/stages/drive_setup.hpp"
#include "sim/stages/drive_space.hpp"
#include "tests/sim/support/happenings.hpp"
#include "tests/sim/support/test_people.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

SimulationConfig with_walkers(int count) {
  SimulationConfig config = test_simulation();
  config.people.walking = count;
  return config;
}

SimulationStreams streams(std::uint64_t seed) {
  SimulationStreams result = test_streams(static_cast<unsigned>(seed));
  result.named = named_streams(seed);
  return result;
}

/// All readings of a type that a run delivers.
template <typename Reading>
std::vector<Reading> run(const SimulationConfig& config) {
  Simulation simulation(config, streams(5));
  std::vector<Reading> readings;
  while (auto frame = simulation.next()) {
    if (auto* reading = std::get_if<Reading>(&frame->data)) readings.push_back(std::move(*reading));
  }
  return readings;
}

TEST(PeopleStage, WithoutPeopleIsNothing) {
  const SimulationConfig config = test_simulation();
  Spaces spaces;
  PeopleStage stage(config, spaces, config.start, {});
  const RayScene scene(ray_primitives(config.world));
  EXPECT_FALSE(stage.due(seconds(1)));
  EXPECT_EQ(stage.around(scene).moving, nullptr);
  EXPECT_TRUE(stage.readings(seconds(1), config.start).empty());
}

TEST(PeopleStage, NeedsStreams) {
  const SimulationConfig config = with_walkers(1);
  Spaces spaces;
  EXPECT_THROW(PeopleStage(config, spaces, config.start, {}), std::invalid_argument);
}

TEST(PeopleStage, TellsWherePeopleAreBetweenSteps) {
  const SimulationConfig config = with_walkers(3);
  Spaces spaces;
  PeopleStage stage(config, spaces, config.start, named_streams(1));
  const RayScene scene(ray_primitives(config.world));
  for (int i = 0; i <= 100; ++i) stage.advance(milliseconds(50 * i), config.start, {0, 0}, scene);
  EXPECT_DOUBLE_EQ(stage.fraction(milliseconds(5025)), 0.5);
  const auto a = stage.readings(milliseconds(5000), config.start);
  const auto b = stage.readings(milliseconds(5025), config.start);
  const auto c = stage.readings(milliseconds(5050), config.start);
  ASSERT_EQ(a.size(), 3U);
  EXPECT_NEAR(b[0].T_map_person.x, 0.5 * (a[0].T_map_person.x + c[0].T_map_person.x), 1e-12);
}

TEST(PeopleStage, TellsWhomTheRobotRanInto) {
  SimulationConfig config = test_simulation();
  config.people.placed = {{2.0, -2.0, 0.0}, {0.5, -2.0, 0.0}};
  Spaces spaces;
  PeopleStage stage(config, spaces, config.start, named_streams(1));
  const RayScene scene(ray_primitives(config.world));
  stage.advance(milliseconds(0), config.start, {0.0, 0.0}, scene);
  EXPECT_TRUE(stage.take_hits().empty());
  stage.advance(milliseconds(50), {0.3, -2.0, 0.0}, {1.0, 0.0}, scene);
  EXPECT_EQ(stage.take_hits(), std::vector<int>{1});
  EXPECT_TRUE(stage.take_hits().empty());
}

TEST(SimulationWithPeople, BeamsEndOnThem) {
  SimulationConfig config = test_simulation();
  config.people.placed = {{-1.0, -1.2, 0.0}};
  config.drive.waypoints.clear();
  const auto scans = run<LidarReading>(config);
  ASSERT_FALSE(scans.empty());
  const auto& last = scans.back();
  const auto on_person = std::count(last.hit_object.begin(), last.hit_object.end(), kHitPerson);
  EXPECT_GE(on_person, 10);  // Two legs of 0.14 m at 0.8 m cover 20 degrees.
  EXPECT_LE(on_person, 30);
  ASSERT_EQ(last.people.size(), 1U);
  EXPECT_NEAR(last.people[0].gap, 0.8 - 0.153 - 0.2, 0.08);
}

/// If the robot ignores people, its true path does not depend on them.
TEST(SimulationWithPeople, DoNotChangeTheCourseOfARobotThatDoesNotYield) {
  SimulationConfig config = with_walkers(12);
  config.people.robot_yields = false;
  const auto with = run<OdometryReading>(config);
  const auto without = run<OdometryReading>(test_simulation());
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); i += 50) {
    EXPECT_EQ(with[i].T_map_base_true, without[i].T_map_base_true);
    EXPECT_EQ(with[i].T_odom_base, without[i].T_odom_base);
  }
}

TEST(SimulationWithPeople, ARobotStopsBeforeSomebodyInItsWayAndThenDrivesRound) {
  SimulationConfig config = test_simulation();
  config.drive.waypoints = {{2.5, -2.0}};
  config.drive.loop = false;
  config.people.placed = {{0.8, -2.0, 1.5}};
  config.duration = seconds(40);
  Simulation simulation(config, streams(1));
  double closest = 10.0;
  int hits = 0;
  while (auto frame = simulation.next()) {
    if (happening<Collision>(*frame)) ++hits;
    const auto* scan = std::get_if<LidarReading>(&frame->data);
    if (scan != nullptr) closest = std::min(closest, scan->people[0].gap);
  }
  EXPECT_EQ(hits, 0);
  EXPECT_GT(closest, 0.02);
  EXPECT_LT((simulation.true_pose().position() - Eigen::Vector2d(2.5, -2.0)).norm(), 0.3);
}

TEST(SimulationWithPeople, AKidnapGoesWhereItGoesWithoutThem) {
  SimulationConfig config = noisy_kidnap_simulation();
  const auto without = run<KidnapRecord>(config);
  config.people.walking = 20;
  config.people.robot_yields = false;
  const auto with = run<KidnapRecord>(config);
  ASSERT_EQ(with.size(), 1U);
  EXPECT_EQ(with[0].T_map_to, without[0].T_map_to);
}

}  // namespace
}  // namespace castaway::sim
