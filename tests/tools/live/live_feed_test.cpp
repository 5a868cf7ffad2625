#include "tools/live/live_feed.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"

namespace castaway::testbed {
namespace {

const std::vector<std::string> kTwo{"a", "b"};

/// A frame taken apart.
struct ReadFrame {
  nlohmann::json head;
  std::string blocks;
};

ReadFrame read_frame(const std::string& bytes) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    size |= static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(i))) << (8 * i);
  }
  return {nlohmann::json::parse(bytes.substr(4, size)), bytes.substr(4 + size)};
}

LiveFeed feed_of_two() {
  RosMap map;
  map.width = 1;
  map.height = 1;
  map.cells = {0};
  return {run_of(kTwo), map, 0.2};
}

TEST(LiveFeed, FramesHoldWhatHappenedSinceTheLastOne) {
  LiveFeed feed = feed_of_two();
  feed.on_scan(record_at(1.0, kTwo));
  feed.on_event(kidnap_to(1.05));
  ScanRecord second = record_at(1.1, kTwo);
  second.localizers[1].estimate.reset();
  feed.on_scan(second);
  const LivePoses poses{
      localization::from_seconds(1.15), SE2{1.0, 2.0, 0.5}, {SE2{3.0, 4.0, 0.1}, {}}};
  const ReadFrame frame = read_frame(feed.take_frame(poses));
  EXPECT_EQ(frame.head.at("now"), 1.15);
  EXPECT_EQ(frame.head.at("truth"), (nlohmann::json{1.0, 2.0, 0.5}));
  EXPECT_EQ(frame.head.at("estimates").at(0), (nlohmann::json{3.0, 4.0, 0.1}));
  EXPECT_TRUE(frame.head.at("estimates").at(1).is_null());
  EXPECT_EQ(frame.head.at("first"), 0);
  ASSERT_EQ(frame.head.at("scans").size(), 2U);
  const auto& scan = frame.head.at("scans").at(1);
  EXPECT_EQ(scan.at(0), 1.1);
  EXPECT_EQ(scan.at(3).at(0).at("answer").size(), 8U);
  EXPECT_TRUE(scan.at(3).at(1).at("answer").is_null());
  EXPECT_EQ(frame.head.at("lidars").size(), 1U);
  std::size_t bytes = 0;
  for (const auto& size : frame.head.at("blocks")) bytes += size.get<std::size_t>();
  EXPECT_EQ(frame.head.at("blocks").size(), 4U);
  EXPECT_EQ(frame.blocks.size(), bytes);
  const ReadFrame next = read_frame(feed.take_frame(poses));
  EXPECT_EQ(next.head.at("first"), 2);
  EXPECT_TRUE(next.head.at("scans").empty());
  EXPECT_TRUE(next.blocks.empty());
  EXPECT_EQ(next.head.at("lidars").size(), 1U);
}

TEST(LiveFeed, EventsAreToldOnce) {
  LiveFeed feed = feed_of_two();
  feed.on_event(kidnap_to(1.05));
  EXPECT_TRUE(feed.has_events());
  const auto said = feed.take_events();
  EXPECT_EQ(said.at("first"), 0);
  const auto& events = said.at("events");
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.at(0).at("kind"), "kidnap");
  EXPECT_EQ(events.at(0).at("time"), 1.05);
  EXPECT_EQ(events.at(0).at("to").size(), 3U);
  EXPECT_FALSE(feed.has_events());
  feed.on_drive(localization::from_seconds(2.0), {{"v", 0.2}, {"w", -1.0}});
  const auto next = feed.take_events();
  EXPECT_EQ(next.at("first"), 1);
  EXPECT_EQ(next.at("events").at(0).at("kind"), "drive");
  EXPECT_EQ(next.at("events").at(0).at("drive").at("w"), -1.0);
}

TEST(LiveFeed, ScansCanBeToldWithoutAFrame) {
  LiveFeed feed = feed_of_two();
  feed.on_scan(record_at(1.0, kTwo));
  (void)feed.take_frame({});
  feed.on_scan(record_at(1.1, kTwo));
  feed.on_scan(record_at(1.2, kTwo));
  EXPECT_EQ(feed.untold_scans(), 2U);
  const auto said = feed.take_scans();
  EXPECT_EQ(said.at("said"), "history");
  EXPECT_EQ(said.at("first"), 1);
  EXPECT_EQ(said.at("scans").size(), 2U);
  const ReadFrame frame = read_frame(feed.take_frame({}));
  EXPECT_EQ(frame.head.at("first"), 3);
  EXPECT_TRUE(frame.blocks.empty());
}

TEST(LiveFeed, HelloShowsWhatIsKnownOfTheMapAndTheNotesOfTheRun) {
  RosMap map;
  map.width = 100;
  map.height = 40;
  map.resolution = 0.1;
  map.cells.assign(4000, -1);
  map.cells[20 * 100 + 20] = 0;
  RunInfo info = run_of(kTwo);
  EXPECT_FALSE(LiveFeed(info, map, 0.2).hello().contains("notes"));
  info.notes = {"skid steer"};
  const auto hello = LiveFeed(info, map, 0.2).hello();
  EXPECT_EQ(hello.at("map").at("width"), 21);  // The cell and 1 m to either side.
  EXPECT_EQ(hello.at("notes"), nlohmann::ordered_json({"skid steer"}));
}

TEST(LiveFeed, HelloHasTheMap) {
  const auto hello = feed_of_two().hello();
  EXPECT_EQ(hello.at("localizers"), nlohmann::ordered_json(kTwo));
  EXPECT_EQ(hello.at("map").at("width"), 1);
  EXPECT_FALSE(hello.at("cells").get<std::string>().empty());
}

TEST(LiveFeed, TellsOfALiftedRobotOnly) {
  LiveFeed feed = feed_of_two();
  LivePoses poses{localization::from_seconds(1.0), {}, {{}, {}}};
  EXPECT_FALSE(read_frame(feed.take_frame(poses)).head.contains("lift"));
  poses.T_footprint_base = Eigen::Translation3d(0.0, 0.0, 0.5) *
                           Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY()) *
                           Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  EXPECT_EQ(read_frame(feed.take_frame(poses)).head.at("lift"), nlohmann::json({0.5, 0.1, -0.2}));
}

TEST(LiveFeed, TellsOfFloorsAndHeights) {
  RosMap map;
  map.width = 1;
  map.height = 1;
  map.cells = {0};
  RunInfo info = run_of(kTwo);
  info.heights = true;
  LiveFeed feed(info, map, 0.2);
  feed.set_levels({{0.0, map}, {3.0, map}});
  const auto hello = feed.hello();
  EXPECT_EQ(hello.at("heights"), true);
  EXPECT_EQ(hello.at("levels").at("z_m").size(), 2U);
  EXPECT_EQ(hello.at("levels").at("cells").at(1), hello.at("cells"));
  ScanRecord record = record_at(1.0, kTwo);
  record.true_pose->T_footprint_base.emplace(Eigen::Translation3d(0.0, 0.0, 3.0));
  record.localizers[0].estimate->footing = {.z = 3.25, .level = 1};
  feed.on_scan(record);
  const nlohmann::json scan = read_frame(feed.take_frame({})).head.at("scans").at(0);
  EXPECT_EQ(scan.at(2), (nlohmann::json{0.1, 0.0, 0.0, 3.0, 0.0, 0.0}));
  EXPECT_EQ(scan.at(3).at(0).at("answer").at(8), 3.25);
  EXPECT_EQ(scan.at(3).at(1).at("answer").size(), 8U);
}

}  // namespace
}  // namespace castaway::testbed
