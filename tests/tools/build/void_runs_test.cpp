// Runs from a world's file to the verdict: a robot that drives counts, one that cannot is void.
#include <gtest/gtest.h>

#include "castaway/stamp.hpp"
#include "tests/tools/support/arm_robot.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// Result of a run.
struct Played {
  std::vector<RunEvent> events;
  double distance = 0.0;  ///< [m]
  double error = 0.0;     ///< [m] Of odometry at the end.
};

Played play(const Scenario& scenario, const std::filesystem::path& base) {
  PreparedSimulation prepared = build_simulation(scenario, base);
  const std::vector<sim::LidarConfig> lidars = prepared.config.lidars;
  const Stamp duration = prepared.config.duration;
  sim::Simulation simulation(std::move(prepared.config), simulation_streams(scenario.seed));
  const SE2 start = to_se2(simulation.start_pose());
  SimulatorSource source(std::move(simulation), lidars, duration);
  Played played;
  std::optional<SE2> last;
  while (const auto frame = source.next()) {
    if (const auto* event = std::get_if<RunEvent>(&frame->data)) played.events.push_back(*event);
    const auto* odometry = std::get_if<OdometryFrame>(&frame->data);
    if (odometry == nullptr) continue;
    if (last) played.distance += distance(*last, odometry->true_pose->T_map_base);
    last = odometry->true_pose->T_map_base;
    played.error = distance(start * odometry->odometry.T_odom_base, *last);
  }
  return played;
}

/// The reasons of all void events.
std::vector<std::string> voids_of(const Played& played) {
  std::vector<std::string> reasons;
  for (const RunEvent& event : played.events) {
    if (event.is<VoidEvent>()) reasons.push_back(names_of(event.what).detail);
  }
  return reasons;
}

Scenario scenario_in(const std::string& world) {
  Scenario scenario;
  scenario.world.file = world;
  scenario.duration_s = 30.0;
  scenario.odometry = sim::ideal_odometry();
  return scenario;
}

std::string box(const std::string& name, const std::string& pose, const std::string& size) {
  return "<model name='" + name + "'><static>1</static><pose>" + pose +
         " 0 0 0</pose><link name='l'><collision name='c'><geometry><box><size>" + size +
         "</size></box></geometry></collision></link></model>";
}

/// SDF of a room of 8 m x 6 m on a slab.
std::string room_on_slab(double top) {
  const std::string z = std::to_string(top + 0.5);
  return "<sdf version='1.6'><world name='slab'>" +
         box("slab", "0 0 " + std::to_string(0.5 * top), "8 6 " + std::to_string(top)) +
         box("n", "0 3 " + z, "8.2 0.2 1") + box("s", "0 -3 " + z, "8.2 0.2 1") +
         box("e", "4 0 " + z, "0.2 6.2 1") + box("w", "-4 0 " + z, "0.2 6.2 1") +
         box("crate", "1.5 1 " + z, "0.6 0.6 1") + "</world></sdf>";
}

class Slab : public testing::TestWithParam<double> {};

TEST_P(Slab, CarriesTheRobotWhateverItsHeight) {
  const TemporaryFolder folder;
  folder.put("w.sdf", room_on_slab(GetParam()));
  const Played played = play(scenario_in("w.sdf"), folder.path());
  EXPECT_TRUE(voids_of(played).empty());
  EXPECT_TRUE(played.events.empty());  // And no collision.
  EXPECT_GT(played.distance, 4.0);
  EXPECT_LT(played.error, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Heights, Slab, testing::Values(0.0099, 0.011, 0.02, 0.034, 0.1, 0.5));

/// The bars are at the height of the chassis and too thin for the planner to see.
TEST(VoidRuns, AreThoseOfARobotThatIsFencedIn) {
  const TemporaryFolder folder;
  std::string fence;
  for (const char* bar :
       {"at: [1.45, 1], size: [0.05, 1, 0.02]", "at: [0.5, 1], size: [0.05, 1, 0.02]",
        "at: [1, 1.45], size: [1, 0.05, 0.02]", "at: [1, 0.5], size: [1, 0.05, 0.02]"}) {
    fence += std::string("  - box: {") + bar + ", bottom: 0.045, in_map: false}\n";
  }
  folder.put(
      "w.yaml",
      "name: cell\nextent: {min: [0, 0], max: [6, 4]}\nstart: [1, 1, 0]\nobjects:\n"
      "  - wall: {points: [[0.1, 0.1], [5.9, 0.1], [5.9, 3.9], [0.1, 3.9]], closed: true}\n" +
          fence + "routes: {out: [[1, 1], [4, 2]]}\n");
  Scenario scenario = scenario_in("w.yaml");
  scenario.drive.route = "out";
  EXPECT_EQ(voids_of(play(scenario, folder.path())).size(), 1U);
}

/// Like TIAGo and Fetch: the waypoints where it has no room are replaced by free places, and it
/// moves back and forth between two of them. A kidnap in between frees it only for a while.
TEST(VoidRuns, AreThoseOfARobotWhoseArmSticksOut) {
  const TemporaryFolder folder;
  Scenario scenario = scenario_in("lab");
  scenario.robot.file = folder.put("arm.urdf", waffle_with_arm()).string();
  scenario.duration_s = 60.0;
  scenario.events.simulated.kidnaps = {{.when = {.value = 30.05}, .min_distance_m = 3.0}};
  EXPECT_EQ(voids_of(play(scenario, ".")), std::vector<std::string>{"stuck"});
}

TEST(VoidRuns, AreNotThoseOfARobotThatIsToStand) {
  Scenario scenario = scenario_in("lab");
  scenario.drive.route = "none";
  EXPECT_TRUE(voids_of(play(scenario, ".")).empty());
  scenario.drive.route = "";
  scenario.drive.wait_s = 28.0;
  EXPECT_TRUE(voids_of(play(scenario, ".")).empty());
}

TEST(VoidRuns, AreNotThoseOfRecordedCommandsThatStand) {
  const TemporaryFolder folder;
  folder.put("standing.csv", "t_s,v,w\n0,0,0\n10,0,0\n");
  folder.put("turning.csv", "t_s,v,w\n0,0,0.4\n");
  Scenario scenario = scenario_in("lab");
  for (const char* log : {"standing.csv", "turning.csv"}) {
    scenario.drive.twist_log = log;
    EXPECT_TRUE(voids_of(play(scenario, folder.path())).empty()) << log;
  }
}

TEST(VoidRuns, AreThoseOfRecordedCommandsAgainstAWall) {
  const TemporaryFolder folder;
  folder.put("ahead.csv", "t_s,v,w\n0,0.3,0\n");
  Scenario scenario = scenario_in("lab");
  scenario.duration_s = 90.0;
  scenario.drive.twist_log = "ahead.csv";
  EXPECT_EQ(voids_of(play(scenario, folder.path())), std::vector<std::string>{"stuck"});
}

TEST(VoidRuns, AreNotThoseOfALocalizerThatHasNoAnswer) {
  Scenario scenario = scenario_in("lab");
  scenario.drive.by = "mh_amcl";
  EXPECT_TRUE(voids_of(play(scenario, ".")).empty());
}

TEST(ShortKidnap, IsToldWithItsKey) {
  Scenario scenario = scenario_in("lab");
  scenario.duration_s = 6.0;
  scenario.events.simulated.kidnaps = {{.when = {.value = 3.0}, .min_distance_m = 80.0}};
  const Played played = play(scenario, ".");
  ASSERT_EQ(played.events.size(), 2U);
  ASSERT_TRUE(played.events[0].is<WarningEvent>());
  EXPECT_TRUE(contains(played.events[0].as<WarningEvent>()->sentence, "min_distance_m"));
  EXPECT_TRUE(played.events[1].is<KidnapEvent>());
}

}  // namespace
}  // namespace castaway::testbed
