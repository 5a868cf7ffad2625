// Localizers that are nodes of ROS 2: castaway (CycloneDDS) and a node on Fast DDS, over the
// loopback interface. Each test has a domain of its own.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

constexpr const char* kRos2Run =
    "run --set outputs.snapshots=false --set outputs.report=false --out run ";

/// A node in the background; it ends when castaway has gone.
class Node {
 public:
  Node(const fs::path& folder, int domain, const std::string& arguments = "")
      : folder_(folder), file_(folder / ("node" + std::to_string(domain) + ".json")) {
    const std::string command = "exec '" CASTAWAY_ROS2_PEER "' --domain " + std::to_string(domain) +
                                " " + arguments + " >'" + file_.string() + "' 2>&1";
    thread_ = std::thread([command] { (void)std::system(command.c_str()); });
  }
  ~Node() {
    if (thread_.joinable()) thread_.join();
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// What it received, once it has ended.
  Json received() {
    thread_.join();
    return Json::parse(text_of(file_));
  }

 private:
  fs::path folder_;
  fs::path file_;
  std::thread thread_;
};

std::string node_in(int domain, const std::string& settings = "") {
  return "--localizer mh_amcl --localizer ros2:" + std::to_string(domain) + " " + settings + " ";
}

Json ros2_summary(const fs::path& folder) {
  return Json::parse(text_of(folder / "run/summary.json"));
}

Json answers_in(const fs::path& folder) {
  return ros2_summary(folder).at("localizers").at("ros2").at("answers");
}

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

// docs.ros.org: topic and type names on the wire, and the quality of service of tf2_ros, of
// nav2_map_server and of sensor data.
TEST(Ros2, TopicsHaveTheNamesTypesAndQualityOfRos2) {
  const fs::path folder = fresh_folder();
  Node node(folder, 102);
  EXPECT_EQ(castaway(folder, kRos2Run + node_in(102) + "--duration 4").exit_code, 0);
  const Json received = node.received();
  const Json expected = {
      {"rt/clock", "rosgraph_msgs::msg::dds_::Clock_ reliable volatile"},
      {"rt/scan", "sensor_msgs::msg::dds_::LaserScan_ best_effort volatile"},
      {"rt/odom", "nav_msgs::msg::dds_::Odometry_ reliable volatile"},
      {"rt/tf", "tf2_msgs::msg::dds_::TFMessage_ reliable volatile"},
      {"rt/tf_static", "tf2_msgs::msg::dds_::TFMessage_ reliable transient_local"},
      {"rt/map", "nav_msgs::msg::dds_::OccupancyGrid_ reliable transient_local"},
      {"rt/initialpose", "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_ reliable volatile"},
      {"rt/robot_description", "std_msgs::msg::dds_::String_ reliable transient_local"}};
  for (const auto& [topic, seen] : expected.items()) {
    EXPECT_EQ(received.at("publications").value(topic, ""), seen) << topic;
  }
  const Json& messages = received.at("messages");
  EXPECT_EQ(messages.at("scan"), 40);
  EXPECT_EQ(messages.at("odom"), 400);
  EXPECT_EQ(messages.at("initialpose"), 1);
  EXPECT_EQ(messages.at("map"), 1);
  expect_contains(received.at("frames"), "odom>base_footprint ");
  expect_contains(received.at("frames"), "base_footprint>base_link ");
  expect_contains(received.at("frames"), "base_link>base_scan ");
  expect_contains(received.at("description"), "<robot name=\"waffle\">");
}

TEST(Ros2, NodesAreFoundHoweverRos2ConfiguresThem) {
  const fs::path folder = fresh_folder();
  for (const char* range : {"localhost", "whitelist", "subnet"}) {
    fs::remove_all(folder / "run");
    Node node(folder, 125, std::string("--range ") + range);
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(125) + "--duration 3").exit_code, 0) << range;
    EXPECT_EQ(answers_in(folder).at("answered"), 30) << range;
  }
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
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(106, "--set localizers.1.ros2.timeout_s=0.05") +
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
  EXPECT_GE(answers_in(folder).at("doubled"), 19);
  EXPECT_EQ(answers_in(folder).at("missing"), 0);
}

TEST(Ros2, MalformedMessagesAreCountedAndHarmNothing) {
  const fs::path folder = fresh_folder();
  Node node(folder, 107, "--garbage");
  const Outcome outcome = castaway(folder, kRos2Run + node_in(107) + "--duration 3");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 30);
  EXPECT_EQ(answers_in(folder).at("malformed"), 60);
  expect_contains(outcome.out, "60 malformed");
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

TEST(Ros2, OtherTypesOnItsTopicsAreNotHeard) {
  const fs::path folder = fresh_folder();
  Node node(folder, 120);
  fs::create_directories(folder / "other");
  Node other(folder / "other", 120, "--wrong-types");
  const Outcome outcome = castaway(folder, kRos2Run + node_in(120) + "--duration 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 200);
  EXPECT_EQ(answers_in(folder).at("malformed"), 0);
}

/// Sends bytes that are no DDS, or begin like it, to the ports of a domain while it lives.
class Noise {
 public:
  explicit Noise(int domain) : first_port_(7400 + 250 * domain) {
    thread_ = std::thread([this] { send(); });
  }
  ~Noise() {
    over_ = true;
    thread_.join();
  }
  Noise(const Noise&) = delete;
  Noise& operator=(const Noise&) = delete;

 private:
  void send() {
    const int file = socket(AF_INET, SOCK_DGRAM, 0);
    std::minstd_rand random(1);
    while (!over_) {
      std::string bytes = random() % 2 == 0 ? "RTPS\x02\x01\x01\x10" : "";
      const std::size_t size = random() % 1400;
      while (bytes.size() < size) bytes += static_cast<char>(random());
      sockaddr_in to{};
      to.sin_family = AF_INET;
      to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      to.sin_port = htons(static_cast<std::uint16_t>(first_port_ + random() % 40));
      ::sendto(file, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    close(file);
  }

  int first_port_;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

TEST(Ros2, GarbageOnThePortsHarmsNothing) {
  const fs::path folder = fresh_folder();
  Node node(folder, 121);
  const Noise noise(121);
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(121, "--set localizers.1.ros2.pace=5") + "--duration 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_GT(answers_in(folder).at("answered"), 150);
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

TEST(Ros2, ALiveRunWithANodeIsRefused) {
  expect_refused(castaway(fresh_folder(), "live --localizer ros2:119"), {"ros2", "castaway run"});
}

TEST(Ros2, TwoRunsInOneDomainDoNotMix) {
  const fs::path folder = fresh_folder();
  Node node(folder, 111);
  std::thread first([&] {
    EXPECT_EQ(castaway(folder,
                       kRos2Run + node_in(111, "--set localizers.1.ros2.pace=2") + "--duration 12")
                  .exit_code,
              0);
  });
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const fs::path other = folder / "other";
  fs::create_directories(other);
  const Outcome outcome = castaway(other, kRos2Run + node_in(111) + "--duration 2");
  first.join();
  expect_refused(outcome, {"someone else publishes /clock in domain 111"});
}

const std::string kWatched =
    "--watch 'rt/castaway/events std_msgs::msg::dds_::String_' "
    "--watch 'rt/castaway/ground_truth/odom nav_msgs::msg::dds_::Odometry_' "
    "--watch 'rt/castaway/mh_amcl/amcl_pose "
    "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_' ";

TEST(Ros2, OthersMayLookOnAtARun) {
  const fs::path folder = fresh_folder();
  const std::string settings =
      "--localizer mh_amcl --set events.0.kidnap.at_s=2 --set 'people.count=2' --duration 8 ";
  EXPECT_EQ(castaway(folder, kRos2Run + settings).exit_code, 0);
  const std::string alone = text_of(folder / "run/mh_amcl.tum");
  fs::remove_all(folder / "run");
  Node node(folder, 112, kWatched);
  const Outcome outcome = castaway(
      folder, kRos2Run + settings + "--ros2 --ros2-domain 112 --ros2-pace 4 --ros2-namespace r1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(text_of(folder / "run/mh_amcl.tum"), alone);
  const Json names = node.received().at("publications");
  for (const char* topic :
       {"clock", "r1/scan", "r1/odom", "r1/tf", "r1/tf_static", "r1/map", "r1/initialpose",
        "r1/robot_description", "r1/joint_states", "r1/castaway/ground_truth/odom",
        "r1/castaway/events", "r1/castaway/people", "r1/castaway/cmd_vel",
        "r1/castaway/mh_amcl/amcl_pose", "r1/castaway/mh_amcl/hypotheses"}) {
    EXPECT_TRUE(names.contains(std::string("rt/") + topic)) << topic;
  }
}

TEST(Ros2, LookersOnGetWhatHappens) {
  const fs::path folder = fresh_folder();
  Node node(folder, 113, kWatched);
  const Outcome outcome =
      castaway(folder, std::string(kRos2Run) + "--localizer mh_amcl --set events.0.kidnap.at_s=6 " +
                           "--duration 12 --ros2 --ros2-domain 113 --ros2-pace 4");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json received = node.received();
  EXPECT_GE(received.at("watched").at("rt/castaway/events"), 1);  // The kidnap.
  EXPECT_GT(received.at("watched").at("rt/castaway/ground_truth/odom"), 500);
  EXPECT_GT(received.at("watched").at("rt/castaway/mh_amcl/amcl_pose"), 50);
  EXPECT_GT(received.at("messages").at("scan"), 50);
  expect_contains(received.at("frames"), "map>odom ");
}

TEST(Ros2, OthersMayLookOnAtARecordedLog) {
  const fs::path folder = fresh_folder();
  EXPECT_EQ(castaway(folder, std::string(kRos2Run) +
                                 "--localizer mh_amcl --duration 8 --set outputs.carmen=true "
                                 "--set outputs.map=true")
                .exit_code,
            0);
  Node node(folder, 114, kWatched);
  const Outcome outcome =
      castaway(folder,
               "replay run/log.carmen --map run/map/map.yaml --start truth --no-pictures --out "
               "again --ros2 --ros2-domain 114 --ros2-pace 4");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json received = node.received();
  EXPECT_GT(received.at("messages").at("scan"), 50);
  EXPECT_GE(received.at("messages").at("map"), 1);
  EXPECT_GT(received.at("watched").at("rt/castaway/mh_amcl/amcl_pose"), 50);
}

TEST(Ros2, ARunWithANodeIsLookedOnWithoutASecondRobot) {
  const fs::path folder = fresh_folder();
  Node node(folder, 115, kWatched);
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(115) + "--duration 6 --ros2 --ros2-domain 115");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 60);
  const Json received = node.received();
  EXPECT_EQ(received.at("messages").at("scan"), 60);
  EXPECT_GT(received.at("watched").at("rt/castaway/ground_truth/odom"), 500);
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

TEST(Ros2, SubscribersThatGetNothingAreNamed) {
  const fs::path folder = fresh_folder();
  Node node(folder, 116, "--watch 'rt/scan sensor_msgs::msg::dds_::LaserScan_'");
  const Outcome outcome = castaway(folder, kRos2Run + node_in(116) + "--duration 2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(text_of(folder / "run/events.csv"),
                  "a subscriber of /scan gets nothing: it asks for more reliability");
}

}  // namespace
}  // namespace castaway::test
