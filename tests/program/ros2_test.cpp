// Localizers that are nodes of ROS 2: castaway (CycloneDDS) and a node on Fast DDS, over the
// loopback interface.
#include <thread>

#include <gtest/gtest.h>

#include "tests/program/ros2_node.hpp"

namespace castaway::test {
namespace {

/// A robot whose scans survive the wire unchanged: its angles are floats.
fs::path exact_robot(const fs::path& folder) {
  std::string urdf = text_of(fs::path(CASTAWAY_SOURCE_DIR) / "robots/waffle/waffle.urdf");
  const auto replace = [&](const std::string& old, const std::string& by) {
    const std::size_t at = urdf.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    urdf.replace(at, old.size(), by);
  };
  replace("<samples>360<", "<samples>401<");
  replace("<min_angle>0<", "<min_angle>-3.125<");
  replace("<max_angle>6.2657320146596<", "<max_angle>3.125<");
  replace("<update_rate>5<", "<update_rate>10<");
  replace("<min>0.12<", "<min>0.125<");
  replace("<max>3.5<", "<max>12<");
  fs::create_directories(folder / "robot");
  fs::create_directory_symlink(fs::path(CASTAWAY_SOURCE_DIR) / "robots/waffle/meshes",
                               folder / "robot/meshes");
  std::ofstream(folder / "robot/waffle.urdf") << urdf;
  return folder / "robot/waffle.urdf";
}

TEST(Ros2, TheNodesTrajectoryIsThatOfTheSameLocalizerInside) {
  const fs::path folder = fresh_folder();
  const std::string robot = exact_robot(folder).string();
  Node node(folder, 101);
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(101) +
                           "--duration 30 --set events.0.kidnap.at_s=8 --set robot=" + robot);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "ros2: 300 of 300 scans answered, 0 missing; 0 answers late");
  EXPECT_EQ(ros2_summary(folder).at("localizers").at("ros2").at("recovery").at("recovered"), 1);
  const std::string ours = text_of(folder / "run/mh_amcl.tum");
  EXPECT_GT(std::count(ours.begin(), ours.end(), '\n'), 290);
  EXPECT_EQ(text_of(folder / "run/ros2.tum"), ours);
}

TEST(Ros2, TheSameRunGivesTheSameTrajectory) {
  const fs::path folder = fresh_folder();
  std::vector<std::string> trajectories;
  for (int i = 0; i < 2; ++i) {
    fs::remove_all(folder / "run");
    Node node(folder, 103);
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(103) + "--duration 10").exit_code, 0);
    trajectories.push_back(text_of(folder / "run/ros2.tum"));
  }
  EXPECT_GT(trajectories[0].size(), 1000U);
  EXPECT_EQ(trajectories[0], trajectories[1]);
}

TEST(Ros2, AnswersStampedAheadAreThoseOfTheirScans) {
  const fs::path folder = fresh_folder();
  Node node(folder, 104, "--ahead 1000000000");
  EXPECT_EQ(castaway(folder,
                     kRos2Run + node_in(104, "--set localizers.1.ros2.ahead_s=1") + "--duration 5")
                .exit_code,
            0);
  EXPECT_EQ(answers_in(folder).at("answered"), 50);
  EXPECT_EQ(answers_in(folder).at("late"), 0);
}

TEST(Ros2, ANodeWithoutTransformsIsHeardByItsPose) {
  const fs::path folder = fresh_folder();
  Node node(folder, 105, "--no-transform");
  EXPECT_EQ(castaway(folder, kRos2Run + node_in(105, "--set localizers.1.ros2.answer=pose") +
                                 "--duration 5")
                .exit_code,
            0);
  EXPECT_EQ(answers_in(folder).at("answered"), 50);
}

TEST(Ros2, CountsWhatIsMissingLateAndDoubled) {
  const fs::path folder = fresh_folder();
  {
    Node node(folder, 106, "--answer-every 4");
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(106, "--set localizers.1.ros2.timeout_s=0.2") +
                                   "--duration 2")
                  .exit_code,
              0);
  }
  EXPECT_EQ(answers_in(folder).at("sent"), 20);
  EXPECT_EQ(answers_in(folder).at("answered"), 5);
  EXPECT_EQ(answers_in(folder).at("missing"), 15);
  fs::remove_all(folder / "run");
  {
    Node node(folder, 106, "--late 400");
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(106, "--set localizers.1.ros2.timeout_s=0.2") +
                                   "--duration 3")
                  .exit_code,
              0);
  }
  EXPECT_GE(answers_in(folder).at("late"), 2);
  EXPECT_GE(answers_in(folder).at("missing"), 2);
  fs::remove_all(folder / "run");
  {
    Node node(folder, 106, "--twice");
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(106) + "--duration 2").exit_code, 0);
  }
  EXPECT_GE(answers_in(folder).at("doubled"), 15);  // Of 20, less those to repeated scans.
  EXPECT_EQ(answers_in(folder).at("missing"), 0);
}

/// A robot with a second lidar that looks back.
fs::path robot_with_two_lidars(const fs::path& folder) {
  const fs::path file = exact_robot(folder);
  std::string urdf = text_of(file);
  const std::string more =
      "<joint name=\"rear_joint\" type=\"fixed\"><parent link=\"base_link\"/>"
      "<child link=\"rear_scan\"/><origin xyz=\"-0.1 0 0.2\" rpy=\"0 0 3.14\"/></joint>"
      "<link name=\"rear_scan\"/><gazebo reference=\"rear_scan\"><sensor name=\"rear\" "
      "type=\"ray\">"
      "<update_rate>10</update_rate><ray><scan><horizontal><samples>180</samples>"
      "<min_angle>-1.5</min_angle><max_angle>1.5</max_angle></horizontal></scan>"
      "<range><min>0.1</min><max>8</max></range></ray></sensor></gazebo></robot>";
  const std::string end = "</robot>";
  urdf.replace(urdf.rfind(end), end.size(), more);
  std::ofstream(file) << urdf;
  return file;
}

TEST(Ros2, ANodeMayTakeOneOfSeveralLidars) {
  const fs::path folder = fresh_folder();
  Node node(folder, 124, "--scan-topic rt/lidar/scan");
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(124) + "--duration 5 --set events=[] --set robot=" +
                           robot_with_two_lidars(folder).string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 50);
  EXPECT_EQ(answers_in(folder).at("missing"), 0);
  const Json received = node.received();
  EXPECT_TRUE(received.at("publications").contains("rt/rear/scan"));
  expect_contains(received.at("frames"), "base_link>rear_scan ");
}

TEST(Ros2, ANodeThatGoesAndComesIsAnEvent) {
  const fs::path folder = fresh_folder();
  Node first(folder, 108, "--scans 20");
  std::thread second([&] {
    (void)first.received();
    Node again(folder, 108, "--unknown-start");
  });
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(108, "--set localizers.1.ros2.pace=4") + "--duration 40");
  second.join();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string events = text_of(folder / "run/events.csv");
  expect_contains(events, "node,the node went,ros2");
  expect_contains(events, "node,the node came back,ros2");
  EXPECT_GT(answers_in(folder).at("answered"), 50);
}

TEST(Ros2, WithoutANodeTheRunGoesOnAndSaysWhatIsMissing) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(109, "--set localizers.1.ros2.start_timeout_s=0.3") +
                           "--duration 2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  expect_contains(outcome.err, "domain 109");
  expect_contains(outcome.err, "nobody subscribes to /scan");
  EXPECT_TRUE(fs::exists(folder / "run/mh_amcl.tum"));
}

TEST(Ros2, BadSettingsAreRefused) {
  const fs::path folder = fresh_folder();
  expect_refused(castaway(folder, "run --localizer ros2:300"), {"ros2:300", "232"});
  const auto set = [&](const std::string& setting) {
    return castaway(folder, kRos2Run + node_in(110, "--set 'localizers.1.ros2." + setting + "'"));
  };
  expect_refused(set("interface=nowhere0"), {"nowhere0"});
  expect_refused(set("topics.scan=my scan"), {"my scan"});
  expect_refused(set("namespace=2nd"), {"2nd"});
  expect_refused(set("answer=guess"), {"answer", "transform"});
  std::ofstream(folder / "open.yaml") << "localizers: [{ros2: {interface: any}}]\n";
  expect_refused(castaway(folder, "run open.yaml"), {"open.yaml", "--allow-programs"});
  EXPECT_FALSE(fs::exists(folder / "run"));
}

/// The robot's true path is a circle of 0.6 m.
void expect_circle(const fs::path& folder) {
  std::istringstream truth(text_of(folder / "run/truth.tum"));
  double t = 0.0;
  double x = 0.0;
  double y = 0.0;
  std::string rest;
  double x_min = 1e9;
  double x_max = -1e9;
  double y_min = 1e9;
  double y_max = -1e9;
  while (truth >> t >> x >> y && std::getline(truth, rest)) {
    x_min = std::min(x_min, x);
    x_max = std::max(x_max, x);
    y_min = std::min(y_min, y);
    y_max = std::max(y_max, y);
  }
  EXPECT_NEAR(x_max - x_min, 0.6, 0.05);
  EXPECT_NEAR(y_max - y_min, 0.6, 0.05);
}

TEST(Ros2, ANodeMayDriveTheRobot) {
  const fs::path folder = fresh_folder();
  for (const char* commands : {"plain", "stamped"}) {
    fs::remove_all(folder / "run");
    Node node(folder, 117, std::string("--drive ") + commands);
    const Outcome outcome =
        castaway(folder, kRos2Run + node_in(117, "--set localizers.1.ros2.drive=true") +
                             "--set events=[] --duration 20");
    EXPECT_EQ(outcome.exit_code, 0) << commands << ": " << outcome.err;
    expect_circle(folder);
  }
}

TEST(Ros2, WithoutCommandsTheRobotStops) {
  const fs::path folder = fresh_folder();
  Node node(folder, 118, "--drive plain --answer-every 1 --scans 50");
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(118, "--set localizers.1.ros2.drive=true") +
                           "--set events=[] --duration 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const double driven = ros2_summary(folder).at("distance_m");
  EXPECT_GT(driven, 0.4);
  EXPECT_LT(driven, 0.8);  // 5 s at 0.12 m/s, and half a second.
}

}  // namespace
}  // namespace castaway::test
