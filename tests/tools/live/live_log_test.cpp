#include "tools/live/live_log.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

/// Truth and answers of all scans, and the events.
class NotesSink final : public RunSink {
 public:
  explicit NotesSink(std::string& notes) : notes_(notes) {}
  void on_event(const RunEvent& event) override {
    notes_ += fmt::format("{} {} {}\n", event.stamp.count(), event_name(event.kind), event.detail);
  }
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override {
    notes_ += fmt::format("{} {:.17g}", record.stamp.count(), record.T_map_base_true->x);
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
