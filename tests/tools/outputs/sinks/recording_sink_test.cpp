#include "tools/outputs/sinks/recording_sink.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/columns.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Values = std::vector<std::int64_t>;

const std::vector<std::string> kRecorded{"a", "<b>x</b>"};

RosMap one_cell() {
  RosMap map;
  map.width = 1;
  map.height = 1;
  map.cells = {0};
  return map;
}

/// Returns the recording of a run of these records and a kidnap at 1.05 s.
std::string file_of(const std::vector<ScanRecord>& records, const RecordingConfig& config = {}) {
  const TemporaryFolder folder;
  RecordingSink sink(folder.path(), run_of(kRecorded), one_cell(), config);
  sink.on_event(kidnap_to(1.05));
  for (const ScanRecord& record : records) sink.on_scan(record);
  sink.finish(localization::from_seconds(3.0), {});
  return read_file(folder.path() / "recording.gz");
}

std::vector<ScanRecord> three_records() {
  return {record_at(0.0, kRecorded), record_at(1.0, kRecorded), record_at(2.0, kRecorded)};
}

Values column(const Recording& recording, const std::string& name) {
  return column_values(recording.sections.at(name));
}

TEST(RecordingSink, KeepsPosesAndBeliefsOfAllScans) {
  const Recording recording = unpack_recording(file_of(three_records()));
  EXPECT_EQ(recording.header.at("scans"), 3);
  EXPECT_EQ(recording.header.at("localizers"), nlohmann::ordered_json(kRecorded));
  EXPECT_EQ(column(recording, "time"), (Values{0, 10000, 20000}));
  EXPECT_EQ(column(recording, "truth/x"), (Values{0, 1000, 2000}));
  EXPECT_EQ(column(recording, "1/y"), (Values{2000, 2000, 2000}));
  EXPECT_EQ(column(recording, "1/yaw"), (Values{1000, 1000, 1000}));
  EXPECT_EQ(column(recording, "0/quality"), (Values{750, 750, 750}));
  EXPECT_EQ(column(recording, "0/probability"), (Values{500, 500, 500}));
}

TEST(RecordingSink, MarksTheScanThatAKidnapTore) {
  EXPECT_EQ(column(unpack_recording(file_of(three_records())), "flags"), (Values{1, 3, 1}));
}

TEST(RecordingSink, KeepsWhatCanBeSeen) {
  RecordingConfig config;
  EXPECT_EQ(unpack_recording(file_of(three_records(), config)).sections.count("scene"), 0U);
  config.scene = R"({"top":2})";
  EXPECT_EQ(unpack_recording(file_of(three_records(), config)).sections.at("scene"), config.scene);
}

TEST(RecordingSink, SaysWhatIsNotThere) {
  std::vector<ScanRecord> records = three_records();
  records[1].true_pose.reset();
  records[1].localizers[0].estimate.reset();
  records[2].localizers[0].estimate->lost = true;
  const Recording recording = unpack_recording(file_of(records));
  EXPECT_EQ(column(recording, "flags"), (Values{1, 2, 1}));
  EXPECT_EQ(column(recording, "truth/x"), (Values{0, 0, 2000}));
  EXPECT_EQ(column(recording, "0/flags"), (Values{1, 0, 3}));
  EXPECT_EQ(column(recording, "0/x"), (Values{0, 0, 2000}));
}

TEST(RecordingSink, MarksWhatIsNotStated) {
  std::vector<ScanRecord> records = three_records();
  records[1].localizers[0].estimate->probability = std::nan("");
  records[2].localizers[0].estimate->quality = std::nan("");
  const Recording recording = unpack_recording(file_of(records));
  EXPECT_EQ(column(recording, "0/probability"), (Values{500, -1000, 500}));
  EXPECT_EQ(column(recording, "0/quality"), (Values{750, 750, -1000}));
}

TEST(RecordingSink, TellsEachLidarOnce) {
  std::vector<ScanRecord> records = three_records();
  for (ScanRecord& record : records) record.scan.ranges.assign(1000, 2.0F);
  records[1].scan.lidar = "rear";
  records[1].scan.T_base_laser.translation().x() = -0.5;
  const Recording recording = unpack_recording(file_of(records));
  const auto& lidars = recording.header.at("lidars");
  ASSERT_EQ(lidars.size(), 2U);
  EXPECT_EQ(lidars.at(1).at("name"), "rear");
  EXPECT_EQ(lidars.at(1).at("T_base_laser").at(3), -0.5);
  // one byte for the lidar, two for 2.01 m, one for each other beam
  EXPECT_EQ(column(recording, "beams/sizes"), (Values{336, 336, 336}));
}

TEST(RecordingSink, KeepsDetailsOfLongRunsLessOften) {
  EXPECT_EQ(detail_period(120.0), 0.0);
  EXPECT_EQ(detail_period(600.0), 0.0);
  EXPECT_DOUBLE_EQ(detail_period(3600.0), 0.6);
  EXPECT_EQ(scan_period(3600.0), 0.0);
  EXPECT_DOUBLE_EQ(scan_period(86400.0), 1.44);
  RecordingConfig config;
  config.detail_every_s = 1.5;
  const Recording recording = unpack_recording(file_of(three_records(), config));
  EXPECT_EQ(column(recording, "time").size(), 3U);
  EXPECT_EQ(column(recording, "detail"), (Values{0, 2}));
  EXPECT_EQ(column(recording, "0/points/sizes").size(), 2U);
}

TEST(RecordingSink, RepeatsToTheByte) {
  EXPECT_EQ(file_of(three_records()), file_of(three_records()));
}

TEST(RecordingSink, LeavesNoFileOfARunThatFailed) {
  const TemporaryFolder folder;
  { const RecordingSink sink(folder.path(), run_of(kRecorded), one_cell(), {}); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(RecordingSink, KeepsHeightsAndFloors) {
  const TemporaryFolder folder;
  RunInfo info = run_of(kRecorded);
  info.heights = true;
  RecordingConfig config;
  config.levels =
      std::make_shared<const LevelMaps>(LevelMaps{{0.0, one_cell()}, {3.0, one_cell()}});
  RecordingSink sink(folder.path(), info, one_cell(), config);
  ScanRecord record = record_at(1.0, kRecorded);
  record.true_pose->T_footprint_base = Eigen::Translation3d(0.0, 0.0, 3.1) *
                                       Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) *
                                       Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  record.localizers[1].estimate->footing = {.z = 3.0, .level = 1};
  sink.on_scan(record);
  sink.finish(localization::from_seconds(3.0), {});
  const Recording recording = unpack_recording(read_file(folder.path() / "recording.gz"));
  EXPECT_EQ(column(recording, "truth/z"), (Values{31000}));
  EXPECT_EQ(column(recording, "truth/roll"), (Values{1000}));
  EXPECT_EQ(column(recording, "truth/pitch"), (Values{2000}));
  EXPECT_EQ(column(recording, "0/z"), (Values{0}));
  EXPECT_EQ(column(recording, "1/z"), (Values{30000}));
  EXPECT_EQ(recording.header.at("heights"), true);
  EXPECT_EQ(recording.header.at("levels").at("z_m"), (nlohmann::ordered_json{0.0, 3.0}));
  EXPECT_TRUE(recording.sections.contains("level/1"));
}

TEST(RecordingSink, KeepsNoTrueHeightsWhereTheyAreUnknown) {
  const TemporaryFolder folder;
  RunInfo info = run_of(kRecorded);
  info.heights = true;
  RecordingSink sink(folder.path(), info, one_cell(), {});
  for (const ScanRecord& record : three_records()) sink.on_scan(record);
  sink.finish(localization::from_seconds(3.0), {});
  const Recording recording = unpack_recording(read_file(folder.path() / "recording.gz"));
  EXPECT_FALSE(recording.sections.contains("truth/z"));
  EXPECT_EQ(column(recording, "0/z"), (Values{0, 0, 0}));
}

TEST(RecordingSink, BeginsHeightsLateWhereTheyAreKnownLate) {
  const TemporaryFolder folder;
  RunInfo info = run_of(kRecorded);
  info.heights = true;
  std::vector<ScanRecord> records = three_records();
  records[1].true_pose->T_footprint_base.emplace(Eigen::Translation3d(0.0, 0.0, 2.0));
  RecordingSink sink(folder.path(), info, one_cell(), {});
  for (const ScanRecord& record : records) sink.on_scan(record);
  sink.finish(localization::from_seconds(3.0), {});
  const Recording recording = unpack_recording(read_file(folder.path() / "recording.gz"));
  EXPECT_EQ(column(recording, "truth/z"), (Values{0, 20000, 0}));
}

TEST(RecordingSink, KeepsNoHeightsOfAPlanarRun) {
  const Recording recording = unpack_recording(file_of(three_records()));
  EXPECT_FALSE(recording.header.contains("heights"));
  EXPECT_FALSE(recording.sections.contains("truth/z"));
}

}  // namespace
}  // namespace castaway::testbed
