// Live runs with nodes of ROS 2: castaway (CycloneDDS) and a node on Fast DDS, over the loopback
// interface.
#include <gtest/gtest.h>

#include "tests/program/ros2_node.hpp"

namespace castaway::test {
namespace {

/// Plays live for some seconds. False: this program has no page for live runs.
bool play_live(const fs::path& folder, const std::string& arguments) {
  const Outcome outcome = castaway(folder, "live --port 0 --play " + arguments, "timeout -s INT 8");
  if (outcome.err.starts_with("castaway: this castaway was built without")) return false;
  EXPECT_EQ(outcome.err, "");
  return true;
}

TEST(Ros2Live, OthersMayLookOn) {
  const fs::path folder = fresh_folder();
  Node node(folder, 122, kWatched + "--imu rt/imu");
  if (!play_live(folder, "--localizer mh_amcl --set imu=true --ros2 --ros2-domain 122")) {
    GTEST_SKIP() << "no page";
  }
  const Json received = node.received();
  EXPECT_GT(received.at("imu").at("readings"), 200);
  EXPECT_GT(received.at("messages").at("scan"), 20);
  EXPECT_GE(received.at("messages").at("map"), 1);
  EXPECT_GT(received.at("watched").at("rt/castaway/mh_amcl/amcl_pose"), 20);
  expect_contains(received.at("description"), "<robot name=\"waffle\">");
}

TEST(Ros2Live, ANodeRidesAlong) {
  const fs::path folder = fresh_folder();
  Node node(folder, 123);
  if (!play_live(folder, node_in(123))) GTEST_SKIP() << "no page";
  EXPECT_GT(node.received().at("messages").at("scan"), 20);
}

TEST(Ros2Live, OthersLookOnAtARunWithANode) {
  const fs::path folder = fresh_folder();
  Node node(folder, 119, kWatched);
  if (!play_live(folder, node_in(119) + "--ros2 --ros2-domain 119")) GTEST_SKIP() << "no page";
  const Json received = node.received();
  EXPECT_GT(received.at("messages").at("scan"), 20);
  EXPECT_GT(received.at("watched").at("rt/castaway/mh_amcl/amcl_pose"), 20);
}

TEST(Ros2Live, ANodeDoesNotDrive) {
  expect_refused(castaway(fresh_folder(),
                          "live --port 0 " + node_in(119) + "--set localizers.1.ros2.drive=true"),
                 {"ros2", "castaway run"});
}

TEST(Ros2Live, ANetworkThatIsNotThereIsRefused) {
  expect_refused(castaway(fresh_folder(), "live --port 0 --ros2 --ros2-interface nowhere0"),
                 {"--ros2", "nowhere0"});
}

}  // namespace
}  // namespace castaway::test
