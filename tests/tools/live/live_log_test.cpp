#include "tools/live/live_log.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/support/two_floors.hpp"
#include "tools/base/files/file.hpp"
#include "tools/build/map3d/map3d_files.hpp"
#include "tools/live/live_loading.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// Truth and answers of all scans, and the events.
class NotesSink final : public RunSink {
 public:
  explicit NotesSink(std::string& notes) : notes_(notes) {}
  void on_event(const RunEvent& event) override {
    notes_ += fmt::format("{} {} {}\n", event.stamp.count(), names_of(event.what).kind,
                          names_of(event.what).detail);
  }
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override {
    notes_ += fmt::format("{} {:.17g}", record.stamp.count(), record.true_pose->T_map_base.x);
    for (const LocalizerRecord& localizer : record.localizers) {
      if (localizer.estimate) notes_ += fmt::format(" {:.17g}", localizer.estimate->T_map_base.x);
    }
    notes_ += "\n";
  }
  void finish(Stamp, const RunTiming&) override {}

 private:
  std::string& notes_;
};

/// A log of 120 scans in a folder.
class LiveLogTest : public testing::Test {
 protected:
  LiveLogTest() { write_office(recorded_office(120), folder_.path()); }

  LiveLog play(const std::string& yaml, std::string& notes) {
    return {read_session(YamlDocument::parse(yaml, "session")),
            [&notes](const RunInfo&, const RosMap&, double) {
              return std::make_unique<NotesSink>(notes);
            }};
  }
  LiveLog play(std::string& notes) {
    return play("log: " + (folder_.path() / "log.carmen").string() +
                    "\nmap: " + (folder_.path() / "map.yaml").string() + "\nstart: truth\n",
                notes);
  }

  TemporaryFolder folder_;
};

void play_until(LiveLog& run, double to_s) {
  while (localization::seconds(run.now()) < to_s && run.step()) {
  }
}

/// A bag on a 3-D map: 3 s at 1 m/s on the lower of two floors, then the same way on the upper one.
class LiveLogInSpaceTest : public testing::Test {
 protected:
  LiveLogInSpaceTest() {
    write_file(folder_.path() / "house.map3d", encode_map3d_file(two_floors(), "house.map3d"));
    ForeignBag bag(folder_.path() / "drive.mcap");
    ros::TFMessage mount = ros_edge(1.0, "base_footprint", "laser", 0.0);
    mount.transforms[0].transform.translation.z = 0.3;
    bag.add("/tf_static", 1'000'000'000, mount);
    for (int tick = 0; tick < 120; ++tick) add_tick(bag, tick);
    bag.finish();
  }

  static void add_tick(ForeignBag& bag, int tick) {
    const double t = 1.0 + 0.05 * tick;
    const auto logged = 1'000'000'000 + static_cast<std::int64_t>(tick) * 50'000'000;
    ros::Odometry odometry = ros_odometry_at(t, t);
    odometry.child_frame_id = "base_footprint";
    bag.add("/odom", logged, odometry);
    ros::Odometry truth = ros_odometry_at(t, tick < 60 ? t : t - 3.0);
    truth.header.frame_id = "map";
    truth.pose.pose.position.y = 2.0;
    truth.pose.pose.position.z = tick < 60 ? 0.0 : 2.0;
    bag.add("/ground_truth/odom", logged, truth);
    if (tick % 2 == 1) bag.add("/scan", logged, ros_scan_at(t, "laser"));
  }

  LiveLog play(const std::string& yaml, std::string& notes) {
    return {read_session(YamlDocument::parse(yaml, "session")),
            [&notes](const RunInfo&, const RosMap&, double) {
              return std::make_unique<NotesSink>(notes);
            }};
  }
  LiveLog play(std::string& notes) { return play(session(), notes); }
  std::string session() {
    return "log: " + (folder_.path() / "drive.mcap").string() +
           "\nmap3d: " + (folder_.path() / "house.map3d").string() +
           "\nstart: truth\nimu_topic: none\n";
  }
  /// Height of base after a kidnap to the place x = 2 m, y = 2 m.
  static double height_after(LiveLog& run, const std::string& level) {
    run.add(R"({"kidnap": {"kind": "teleport", "pose": [2.0, 2.0, 0.0])" + level + "}}");
    play_until(run, localization::seconds(run.now()) + 0.2);
    EXPECT_NEAR(run.true_pose()->x, 2.0, 0.25);
    return run.T_footprint_base().translation().z();
  }

  TemporaryFolder folder_;
};

TEST_F(LiveLogInSpaceTest, HasFloorsAndHeights) {
  std::string notes;
  LiveLog run = play(notes);
  ASSERT_NE(run.levels(), nullptr);
  ASSERT_EQ(run.levels()->size(), 2U);
  EXPECT_NEAR(run.levels()->at(1).z, 2.0, 0.05);
  play_until(run, 1.0);
  EXPECT_EQ(run.T_footprint_base().translation().z(), 0.0);
  ASSERT_TRUE(run.estimates().at(0));  // Of mh_amcl:3d, the default.
  play_until(run, 4.0);
  EXPECT_EQ(run.T_footprint_base().translation().z(), 2.0);
}

TEST_F(LiveLogInSpaceTest, IsKidnappedToTheFloorThatIsChosen) {
  std::string notes;
  LiveLog run = play(notes);
  play_until(run, 0.5);
  EXPECT_EQ(height_after(run, R"(, "level": 1)"), 2.0);
  EXPECT_EQ(height_after(run, R"(, "level": 0)"), 0.0);
  EXPECT_TRUE(contains(error_of([&] { height_after(run, R"(, "level": 5)"); }),
                       "holds no true poses there"));
}

TEST_F(LiveLogInSpaceTest, ABagThatAPageBringsIsPlayedOnTheSame3dMap) {
  LiveSetup setup;
  setup.session = read_session(YamlDocument::parse(session(), "session"));
  setup.files = folder_.path();
  const LiveSetup changed = with_file(setup, "drive.mcap", "");
  ASSERT_TRUE(changed.session);
  EXPECT_EQ(changed.session->map3d, (folder_.path() / "house.map3d").string());
  EXPECT_EQ(changed.session->localizers.size(), 1U);
  write_file(folder_.path() / "walk.log", "");
  setup.session->base_height = 0.4;
  EXPECT_EQ(with_file(setup, "walk.log", "").session->base_height, 0.4);
}

TEST_F(LiveLogInSpaceTest, WhatItSavesRepeatsIt) {
  std::string live;
  LiveLog run = play(live);
  play_until(run, 1.0);
  (void)height_after(run, R"(, "level": 1)");
  const std::string saved = run.saved();
  EXPECT_TRUE(contains(saved, "map3d: " + (folder_.path() / "house.map3d").string()));
  EXPECT_TRUE(contains(saved, "imu_topic: none"));
  std::string again;
  LiveLog repeated = play(saved, again);
  while (repeated.step()) {
  }
  EXPECT_EQ(again, live);
  EXPECT_EQ(repeated.saved(), saved);
}

TEST_F(LiveLogTest, IsKidnappedBySplicingAndRepeatsIt) {
  std::string live;
  LiveLog run = play(live);
  play_until(run, 4.1);
  run.add(R"({"kidnap": {"kind": "teleport", "pose": [4.0, 4.0, 2.0]}})");
  play_until(run, 8.0);
  run.add(R"({"localizer": {"name": "mh_amcl", "do": "relocalize"}})");
  play_until(run, 11.0);
  run.add(R"({"splice": {"to_scan": 3}})");
  run.add(R"({"localizer": {"name": "mh_amcl", "do": "initialize", "pose": [1.0, 2.0, 0.5]}})");
  play_until(run, 15.0);

  std::string again;
  LiveLog repeated = play(run.saved(), again);
  while (repeated.step()) {
  }
  EXPECT_EQ(again, live);
  EXPECT_NE(live.find("kidnap splice"), std::string::npos);
  EXPECT_NE(live.find("relocalize"), std::string::npos);
  EXPECT_EQ(repeated.saved(), run.saved());
}

TEST_F(LiveLogTest, GoesToTheRecordedPoseThatIsNearest) {
  std::string notes;
  LiveLog run = play(notes);
  play_until(run, 4.0);
  run.add(R"({"kidnap": {"kind": "teleport", "pose": [1.5, 3.2, -1.57]}})");
  play_until(run, 4.5);
  EXPECT_NEAR(run.true_pose()->x, 1.5, 0.12);
  EXPECT_NEAR(run.true_pose()->y, 3.2, 0.2);
}

TEST_F(LiveLogTest, GoesFarAwayAndToALookAlike) {
  std::string notes;
  LiveLog run = play(notes);
  for (const char* kind : {"teleport", "look_alike"}) {
    play_until(run, localization::seconds(run.now()) + 1.0);
    const SE2 before = *run.true_pose();
    run.add(nlohmann::json{{"kidnap", {{"kind", kind}, {"min_distance_m", 1.0}}}}.dump());
    play_until(run, localization::seconds(run.now()) + 0.4);
    EXPECT_GT(localization::distance(before, *run.true_pose()), 0.7) << kind;
  }
}

TEST_F(LiveLogTest, RefusesWhatALogCannotDo) {
  std::string notes;
  LiveLog run = play(notes);
  const std::string before = run.saved();
  const auto trouble = [&](const std::string& event) { return error_of([&] { run.add(event); }); };
  EXPECT_TRUE(contains(trouble(R"({"box": {"at": [1, 1], "size": [1, 1, 1]}})"), "no more"));
  EXPECT_TRUE(contains(trouble(R"({"fault": {"kind": "lidar-dropout", "for_s": 1}})"), "no more"));
  EXPECT_TRUE(contains(trouble(R"({"kidnap": {"kind": "nudge"}})"), "spliced only"));
  EXPECT_TRUE(contains(trouble(R"({"kidnap": {"kind": "teleport", "pose": [90, 90, 0]}})"),
                       "never within 2 m"));
  EXPECT_TRUE(contains(trouble(R"({"splice": {"to_scan": 120}})"), "there is no scan 120"));
  EXPECT_TRUE(contains(trouble(R"({"splice": {"to_scan": -1}})"), "a splice is"));
  EXPECT_TRUE(contains(trouble(R"({"localizer": {"name": "amcl", "do": "off"}})"), "amcl"));
  EXPECT_EQ(run.saved(), before);
}

TEST_F(LiveLogTest, EndsWithItsLog) {
  std::string notes;
  LiveLog run = play(notes);
  play_until(run, 1e6);
  EXPECT_FALSE(run.step());
  EXPECT_EQ(run.recorded_scans(), 120U);
  run.add(R"({"splice": {"to_scan": 0}})");  // It goes on after a jump.
  EXPECT_TRUE(run.step());
}

}  // namespace
}  // namespace castaway::testbed
