// Runs on the wire of ROS 2: what others see there, and what they send that nobody wants. castaway
// is on CycloneDDS, the others on Fast DDS.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "tests/program/ros2_node.hpp"

namespace castaway::test {
namespace {

// docs.ros.org: topic and type names on the wire, and the quality of service of tf2_ros, of
// nav2_map_server and of sensor data.
TEST(Ros2Wire, TopicsHaveTheNamesTypesAndQualityOfRos2) {
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
  // The first ones are repeated if the node is slow to begin.
  EXPECT_EQ(received.at("stamps"), Json({{"scan", 40}, {"odom", 400}}));
  EXPECT_GE(received.at("messages").at("initialpose"), 1);
  EXPECT_EQ(received.at("messages").at("map"), 1);
  expect_contains(received.at("frames"), "odom>base_footprint ");
  expect_contains(received.at("frames"), "base_footprint>base_link ");
  expect_contains(received.at("frames"), "base_link>base_scan ");
  expect_contains(received.at("description"), "<robot name=\"waffle\">");
}

TEST(Ros2Wire, NodesAreFoundHoweverRos2ConfiguresThem) {
  const fs::path folder = fresh_folder();
  for (const char* range : {"localhost", "whitelist", "subnet"}) {
    fs::remove_all(folder / "run");
    Node node(folder, 125, std::string("--range ") + range);
    EXPECT_EQ(castaway(folder, kRos2Run + node_in(125) + "--duration 3").exit_code, 0) << range;
    EXPECT_EQ(answers_in(folder).at("answered"), 30) << range;
  }
}

TEST(Ros2Wire, MalformedMessagesAreCountedAndHarmNothing) {
  const fs::path folder = fresh_folder();
  Node node(folder, 107, "--garbage");
  const Outcome outcome = castaway(folder, kRos2Run + node_in(107) + "--duration 3");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 30);
  const int malformed = answers_in(folder).at("malformed");
  EXPECT_GE(malformed, 60);  // More if the first scan had to be repeated.
  expect_contains(outcome.out, std::to_string(malformed) + " malformed");
}

TEST(Ros2Wire, OtherTypesOnItsTopicsAreNotHeard) {
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

TEST(Ros2Wire, GarbageOnThePortsHarmsNothing) {
  const fs::path folder = fresh_folder();
  Node node(folder, 121);
  const Noise noise(121);
  const Outcome outcome = castaway(folder, kRos2Run + node_in(121) + "--duration 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(answers_in(folder).at("answered"), 200) << node.received().dump();
}

TEST(Ros2Wire, TwoRunsInOneDomainDoNotMix) {
  const fs::path folder = fresh_folder();
  Node node(folder, 111);
  std::thread first([&] {
    EXPECT_EQ(castaway(folder,
                       kRos2Run + node_in(111, "--set localizers.1.ros2.pace=2") + "--duration 24")
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

TEST(Ros2Wire, SubscribersThatGetNothingAreNamed) {
  const fs::path folder = fresh_folder();
  Node node(folder, 116, "--watch 'rt/scan sensor_msgs::msg::dds_::LaserScan_'");
  const Outcome outcome = castaway(folder, kRos2Run + node_in(116) + "--duration 2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(text_of(folder / "run/events.csv"),
                  "a subscriber of /scan gets nothing: it asks for more reliability");
}

TEST(Ros2Wire, OthersMayLookOnAtARun) {
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

TEST(Ros2Wire, LookersOnGetWhatHappens) {
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

TEST(Ros2Wire, OthersMayLookOnAtARecordedLog) {
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

constexpr const char* kInSpace =
    "--set events=[] --set 'imu={rate_hz: 50}' "
    "--set 'lidar={beams: 90, elevations_deg: [-5, 0, 5, 10], rate_hz: 10}' ";

/// An Imu and clouds of `kInSpace`.
void expect_imu_and_points(const Json& received) {
  const Json& imu = received.at("imu");
  const int readings = imu.at("readings");
  EXPECT_GT(readings, 200) << imu.dump();  // Of 400: its topic is new with the first one.
  EXPECT_EQ(imu.at("frame"), "base_footprint");
  EXPECT_EQ(imu.at("period_ns"), 20'000'000);
  EXPECT_GE(imu.at("first_ns"), 1'000'000'000);
  EXPECT_TRUE(imu.at("without_orientation"));
  EXPECT_NEAR(imu.at("force").at(2).get<double>() / readings, 9.81, 0.3) << imu.dump();
  const Json& points = received.at("points");
  EXPECT_GT(points.at("clouds"), 40) << points.dump();  // Of 80.
  EXPECT_EQ(points.at("frame"), "base_scan");
  EXPECT_EQ(points.at("height"), 4);
  EXPECT_EQ(points.at("width"), 90);
  EXPECT_EQ(points.at("fields"), "x y z range time ring ");
  EXPECT_TRUE(points.at("whole"));
  EXPECT_GT(points.at("returns"), 180);
  EXPECT_EQ(points.at("wrong"), 0);
  const Json& publications = received.at("publications");
  EXPECT_EQ(publications.value("rt/r1/imu", publications.value("rt/imu", "")),
            "sensor_msgs::msg::dds_::Imu_ best_effort volatile");
  EXPECT_EQ(publications.value("rt/r1/points", publications.value("rt/points", "")),
            "sensor_msgs::msg::dds_::PointCloud2_ best_effort volatile");
}

TEST(Ros2Wire, LookersOnGetImuAndPoints) {
  const fs::path folder = fresh_folder();
  Node node(folder, 126, "--imu rt/r1/imu --points rt/r1/points");
  const Outcome outcome =
      castaway(folder, std::string(kRos2Run) + "--localizer mh_amcl " + kInSpace +
                           "--duration 8 --ros2 --ros2-domain 126 --ros2-pace 2 "
                           "--ros2-namespace r1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_imu_and_points(node.received());
}

TEST(Ros2Wire, ALocalizerGetsImuAndPoints) {
  const fs::path folder = fresh_folder();
  Node node(folder, 127, "--imu rt/imu --points rt/points");
  const Outcome outcome = castaway(folder, kRos2Run + node_in(127) + kInSpace + "--duration 8");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 80);
  expect_imu_and_points(node.received());
}

TEST(Ros2Wire, ARunWithANodeIsLookedOnWithoutASecondRobot) {
  const fs::path folder = fresh_folder();
  Node node(folder, 115, kWatched);
  const Outcome outcome =
      castaway(folder, kRos2Run + node_in(115) + "--duration 6 --ros2 --ros2-domain 115");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(answers_in(folder).at("answered"), 60);
  const Json received = node.received();
  EXPECT_EQ(received.at("stamps").at("scan"), 60);
  EXPECT_GT(received.at("watched").at("rt/castaway/ground_truth/odom"), 500);
}

}  // namespace
}  // namespace castaway::test
