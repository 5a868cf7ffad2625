#include "tools/build/foreign/message_text.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/build/foreign/message.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using localization::from_seconds;

LaserScan small_scan() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  LaserScan scan;
  scan.stamp = localization::Stamp(1'700'000'000'123'456'789);
  scan.time_increment = std::chrono::nanoseconds(277'777);
  scan.angle_min = -0.1;
  scan.angle_increment = 0.1;
  scan.range_min = 0.12;
  scan.range_max = 12.0;
  scan.ranges = {1.1F, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN(), 0.3333333F};
  scan.T_base_laser = Eigen::Translation3d(0.1, -0.2, 0.3) *
                      Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  scan.lidar = "front";
  return scan;
}

Greeting small_greeting() {
  Greeting greeting{"mine", 18'446'744'073'709'551'615U, {}, "/maps/a.yaml", {}};
  greeting.map = {"a", 3, 2, 0.05, -1.0, 2.0, 0.1, {-1, 0, 100, 37, 0, -1}};
  greeting.lidars = {lidar_facts(small_scan())};
  return greeting;
}

TEST(MessageText, WritesScansAsTheProtocolSays) {
  std::string text;
  append_scan(small_scan(), text);
  EXPECT_EQ(text, R"({"type":"scan","stamp_ns":1700000000123456789,"lidar":"front",)"
                  R"("time_increment_s":0.000277777,"ranges":[1.1,null,-1,-1,0.3333333]})"
                  "\n");
}

TEST(MessageText, WritesOdometryWithItsVelocity) {
  std::string text;
  append_odometry({from_seconds(1.5), {0.1, -0.2, 0.3}}, {0.5, 0.0, -0.25}, text);
  EXPECT_EQ(
      text,
      R"({"type":"odometry","stamp_ns":1500000000,"pose":[0.1,-0.2,0.3],"twist":[0.5,0,-0.25]})"
      "\n");
}

TEST(MessageText, WritesStartsAndUnknownStarts) {
  std::string text;
  append_initialize(std::nullopt, text);
  append_initialize(
      localization::PoseWithCovariance{{1.0, 2.0, 3.0}, Eigen::Vector3d(4, 5, 6).asDiagonal()},
      text);
  EXPECT_EQ(
      text,
      R"({"type":"initialize","pose":null,"covariance":null})"
      "\n"
      R"({"type":"initialize","pose":[1.0,2.0,3.0],"covariance":[4.0,0.0,0.0,0.0,5.0,0.0,0.0,0.0,6.0]})"
      "\n");
}

TEST(MessageText, HelloHoldsTheMapByteByByte) {
  std::string text;
  append_hello(small_greeting(), R"({"particles": 500})", text);
  const Json hello = Json::parse(text);
  EXPECT_EQ(hello.at("protocol"), 1);
  EXPECT_EQ(hello.at("params").at("particles"), 500);
  EXPECT_EQ(hello.at("map").at("cells"), "/wBkJQD/");  // ff 00 64 25 00 ff
  EXPECT_EQ(hello.at("map").at("origin"), Json({-1.0, 2.0, 0.1}));
  const Json& mount = hello.at("lidars").at(0).at("mount");
  EXPECT_NEAR(mount.at("yaw"), 0.7, 1e-12);
  EXPECT_NEAR(mount.at("roll"), 0.1, 1e-12);
  EXPECT_NEAR(mount.at("pitch"), 0.0, 1e-12);
}

TEST(MessageText, SurvivesNamesThatAreNoUtf8) {
  Greeting greeting = small_greeting();
  greeting.map.name = "caf\xe9";
  std::string text;
  append_hello(greeting, "{}", text);
  EXPECT_TRUE(Json::accept(text));
}

TEST(MessageReader, ReadsBackWhatIsWritten) {
  std::string text;
  append_hello(small_greeting(), "{}", text);
  MessageReader reader;
  const auto greeting = std::get<Greeting>(reader.read(text));
  EXPECT_EQ(greeting.seed, small_greeting().seed);
  EXPECT_EQ(greeting.map.cells, small_greeting().map.cells);
  EXPECT_EQ(greeting.map_file, "/maps/a.yaml");
  text.clear();
  append_scan(small_scan(), text);
  const auto scan = std::get<LaserScan>(reader.read(text));
  EXPECT_EQ(scan.stamp, small_scan().stamp);
  EXPECT_EQ(scan.time_increment, small_scan().time_increment);
  EXPECT_EQ(scan.T_base_laser.matrix(), small_scan().T_base_laser.matrix());
  EXPECT_EQ(scan.ranges[0], 1.1F);
  EXPECT_EQ(scan.ranges[1], std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(scan.ranges[2]));
  EXPECT_EQ(scan.ranges[4], 0.3333333F);
  text.clear();
  append_bye(text);
  EXPECT_TRUE(std::holds_alternative<ByeMessage>(reader.read(text)));
}

TEST(MessageReader, RefusesWhatIsNotOfTheProtocol) {
  MessageReader reader;
  for (const char* line : {"", "[]", "{}", R"({"type":"dance"})", R"({"type":"scan"})",
                           R"({"type":"hello","protocol":2})"}) {
    EXPECT_THROW((void)reader.read(line), std::runtime_error) << line;
  }
}

}  // namespace
}  // namespace castaway::testbed
