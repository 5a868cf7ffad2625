// The sink writes the recording that the tests of the player read (tests/data/recording/small.bin),
// so both sides are tested against the same bytes.
#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_map.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/gzip.hpp"
#include "tools/outputs/sinks/recording_sink.hpp"

namespace castaway::testbed {
namespace {

const std::vector<std::string> kNames{"a", "</script>\"b\""};

localization::PopulationView population() {
  localization::PopulationView view;
  view.id = 4;
  view.T_map_base = {1.0, 2.0, 0.5};
  view.quality = 0.25;
  view.share = 0.75;
  view.selected = true;
  view.particles = {{1.1, 2.0, 0.0}, {0.9, 1.97, 0.0}};
  return view;
}

/// Scans at 1, 0 and 2 s in this order of delivery, with beams at 0, 90 and 180 degrees, one of
/// them a miss.
std::vector<ScanRecord> fixture_records() {
  std::vector<ScanRecord> records;
  for (const double t : {1.0, 0.0, 2.0}) {
    ScanRecord& record = records.emplace_back(record_at(t, kNames));
    record.scan.angle_increment = 1.5;
    record.scan.range_max = 10.0;
    record.scan.ranges = {1.0F, std::numeric_limits<float>::infinity(), 2.5F};
    record.scan.T_base_laser.translation() = Eigen::Vector3d(0.1, 0.0, 0.2);
    record.localizers[0].diagnostics.populations = {population()};
  }
  records[0].people.people.push_back({7, {-1.0, 2.5, 1.0}, Eigen::Vector2d::Zero(), 1.0});
  records[1].localizers[1].estimate.reset();
  records[2].localizers[1].estimate->lost = true;
  return records;
}

/// Compares the sink's file of these records with a file of tests/data/recording.
void expect_kept(const RunInfo& info, const RecordingConfig& config,
                 const std::vector<ScanRecord>& records, const std::string& name) {
  const TemporaryFolder folder;
  RecordingSink sink(folder.path(), info, recorded_map(), config);
  sink.on_event(kidnap_to(1.05));
  for (const ScanRecord& record : records) sink.on_scan(record);
  sink.finish(localization::from_seconds(3.0), {});
  const std::string bytes = gunzip(read_file(folder.path() / "recording.gz"));
  const std::filesystem::path kept =
      std::filesystem::path(CASTAWAY_SOURCE_DIR) / "tests/data/recording" / name;
  const std::filesystem::path now =
      std::filesystem::path(testing::TempDir()) / ("castaway-recording-" + name);
  write_file(now, bytes);
  EXPECT_TRUE(std::filesystem::exists(kept) && read_file(kept) == bytes)
      << "the format changed: raise its version, copy " << now << " to " << kept
      << " and change what reads it: web/src/recording.js";
}

TEST(RecordingFixture, IsWhatTheSinkWrites) {
  RecordingConfig config;
  config.robot_radius_m = 0.25;
  expect_kept(run_of(kNames), config, fixture_records(), "small.bin");
}

TEST(RecordingFixture, OfFloorsIsWhatTheSinkWrites) {
  RecordingConfig config;
  RosMap upper = recorded_map();
  upper.cells.assign(upper.cells.size(), 0);
  config.levels = std::make_shared<const LevelMaps>(LevelMaps{{0.0, recorded_map()}, {3.0, upper}});
  RunInfo info = run_of(kNames);
  info.heights = true;
  std::vector<ScanRecord> records = fixture_records();
  for (ScanRecord& record : records) {
    const double z = localization::seconds(record.stamp);
    record.true_pose->T_footprint_base = Eigen::Translation3d(0.0, 0.0, 1.5 * z) *
                                         Eigen::AngleAxisd(0.125, Eigen::Vector3d::UnitY());
    record.localizers[0].estimate->footing = {.z = 1.5 * z, .level = z < 2.0 ? 0 : 1};
    record.localizers[0].diagnostics.populations[0].footing = {.z = 3.0, .level = 1};
  }
  expect_kept(info, config, records, "levels.bin");
}

}  // namespace
}  // namespace castaway::testbed
