#include "tools/play/replay/recorded_log.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/build/recorded/carmen_source.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// A log of 60 scans in a folder.
class RecordedLogTest : public testing::Test {
 protected:
  RecordedLogTest() { write_office(recorded_office(60), folder_.path()); }

  [[nodiscard]] std::string log() const { return (folder_.path() / "log.carmen").string(); }

  [[nodiscard]] ReplaySession session(const std::string& more = "") const {
    return read_session(YamlDocument::parse(
        "log: " + log() + "\nmap: " + (folder_.path() / "map.yaml").string() + "\n" + more,
        "session"));
  }

  /// The frames that it plays.
  [[nodiscard]] Frames frames_of(const std::string& more = "") const {
    const ReplaySession asked = session(more);
    return all_frames(*spliced_source(open_log(asked), asked));
  }

  /// Those of the log's own source.
  [[nodiscard]] Frames carmen(const CarmenSourceConfig& config) const {
    CarmenSource source(log(), config);
    return all_frames(source);
  }

  TemporaryFolder folder_;
};

std::vector<std::int64_t> stamps_of(const Frames& frames) {
  std::vector<std::int64_t> stamps;
  for (const Frame& frame : frames) stamps.push_back(frame.stamp.count());
  return stamps;
}

TEST_F(RecordedLogTest, PlaysTheSameScansAsTheSourceOfTheLog) {
  using Scans = CarmenSourceConfig::Scans;
  EXPECT_EQ(stamps_of(frames_of()), stamps_of(carmen({})));
  EXPECT_EQ(stamps_of(frames_of("from_scan: 7\nscans: 5\n")),
            stamps_of(carmen({.from_scan = 7, .scans = 5})));
  EXPECT_EQ(stamps_of(frames_of("from_scan: 7\nscans: 5\nscans_used: even\n")),
            stamps_of(carmen({.from_scan = 7, .scans = 5, .selection = Scans::kEven})));
  EXPECT_EQ(stamps_of(frames_of("from_scan: 7\nscans_used: odd\n")),
            stamps_of(carmen({.from_scan = 7, .selection = Scans::kOdd})));
}

TEST_F(RecordedLogTest, JumpsAnywhereInTheLog) {
  const Frames frames =
      frames_of("scans: 12\nevents: [{splice: {after_scans: 10, to_scan: 50}}]\n");
  ASSERT_EQ(frames.size(), 20U + 1U + 4U);
  const auto& event = std::get<RunEvent>(frames[20].data);
  EXPECT_EQ(names_of(event.what).detail, "splice");
  EXPECT_NEAR(event.T_map_to->x, 3.0 + 1.5 * std::cos(50 * 0.1 / 1.5), 1e-5);
}

TEST_F(RecordedLogTest, KnowsWhereItStarts) {
  const ReplaySession asked = session("start: truth\nfrom_scan: 20\n");
  const RecordedLog opened = open_log(asked);
  const auto start = initial_pose(asked, opened, *spliced_source(opened, asked));
  ASSERT_TRUE(start);
  EXPECT_NEAR(start->T_map_base.x, 3.0 + 1.5 * std::cos(20 * 0.1 / 1.5), 1e-5);
  EXPECT_FALSE(initial_pose(session(), opened, *spliced_source(opened, asked)));
}

TEST_F(RecordedLogTest, TurnsTruePosesIntoTheFrameOfTheMap) {
  const Frames frames = frames_of("scans: 4\n");
  const Frames moved = frames_of("scans: 4\ntruth_in_map: [10, -2, 1.5707963267948966]\n");
  ASSERT_EQ(moved.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto* scan = std::get_if<ScanFrame>(&frames[i].data);
    const SE2 T_truth_base =
        (scan ? scan->true_pose : std::get<OdometryFrame>(frames[i].data).true_pose)->T_map_base;
    const SE2 T_map_base = (scan ? std::get<ScanFrame>(moved[i].data).true_pose
                                 : std::get<OdometryFrame>(moved[i].data).true_pose)
                               ->T_map_base;
    EXPECT_NEAR(T_map_base.x, 10.0 - T_truth_base.y, 1e-9);
    EXPECT_NEAR(T_map_base.y, -2.0 + T_truth_base.x, 1e-9);
    EXPECT_NEAR(std::cos(T_map_base.yaw), -std::sin(T_truth_base.yaw), 1e-9);
    EXPECT_NEAR(std::sin(T_map_base.yaw), std::cos(T_truth_base.yaw), 1e-9);
  }
}

TEST_F(RecordedLogTest, NamesTheLogInErrors) {
  EXPECT_TRUE(contains(error_of([&] { (void)frames_of("from_scan: 60\n"); }),
                       "log.carmen: there is no scan 60"));
  EXPECT_TRUE(contains(
      error_of([] { (void)open_log(read_session(YamlDocument::parse("log: none.log\n", "s"))); }),
      "none.log: cannot be read"));
  EXPECT_TRUE(contains(
      error_of([&] { (void)open_log(read_session(YamlDocument::parse("log: " + log(), "s"))); }),
      "--map is missing"));
}

}  // namespace
}  // namespace castaway::testbed
