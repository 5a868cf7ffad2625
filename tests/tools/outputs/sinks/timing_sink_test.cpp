#include "tools/outputs/sinks/timing_sink.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/process/git_commit.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using localization::from_seconds;

TEST(TimingSink, SumsUpWhatTheClockMeasured) {
  const TemporaryFolder folder;
  TimingSink sink(folder.path(), run_of({"a", "silent"}));
  for (const int ms : {4, 1, 3}) {
    ScanRecord record = record_at(10.0 + ms, {"a"});
    record.localizers[0].update_cpu = std::chrono::milliseconds(ms);
    record.localizers[0].stage_cpu = {{"match", std::chrono::microseconds(500)}};
    record.localizers.resize(1);
    record.localizers.push_back({"silent", {}, {}, {}, {}});
    sink.on_scan(record);
  }
  sink.finish(from_seconds(21.0), {2.0, {{"lidar", 0.25}, {"render", 0.5}}, 0.5});
  const Json timing = Json::parse(read_file(folder.path() / "timing.json"));
  EXPECT_EQ(timing.at("wall_s"), 2.0);
  EXPECT_EQ(timing.at("load_s"), 0.5);
  EXPECT_EQ(timing.at("realtime_factor"), 5.0);  // from 11 s to 21 s
  EXPECT_EQ(
      timing.at("cpu_s").dump(),
      R"({"physics":0.0,"lidar":0.25,"people":0.0,"localizers":0.0,"sinks":0.0,"render":0.5})");
  const Json& update = timing.at("/localizers/a/update_ms"_json_pointer);
  EXPECT_NEAR(update.at("mean"), 8.0 / 3.0, 1e-12);
  EXPECT_NEAR(update.at("median"), 3.0, 1e-12);
  EXPECT_NEAR(update.at("p99"), 3.98, 1e-12);
  EXPECT_NEAR(update.at("max"), 4.0, 1e-12);
  EXPECT_EQ(timing.at("/localizers/silent/update_ms/max"_json_pointer), 0.0);
  const Json& stage = timing.at("/localizers/a/stages_ms/match"_json_pointer);
  EXPECT_EQ(stage.at("scans"), 3);
  EXPECT_NEAR(stage.at("mean"), 0.5, 1e-12);
  EXPECT_NEAR(stage.at("max"), 0.5, 1e-12);
  EXPECT_TRUE(timing.at("/localizers/silent/stages_ms"_json_pointer).empty());
  EXPECT_GT(timing.at("/memory_mb/peak"_json_pointer).get<double>(), 1.0);
  EXPECT_TRUE(timing.at("/made/date"_json_pointer).get<std::string>().ends_with(" UTC"));
  EXPECT_TRUE(contains(timing.at("/made/machine"_json_pointer).get<std::string>(), " core"));
  EXPECT_EQ(timing.at("made").value("commit", ""), git_commit(std::filesystem::current_path()));
  const std::string csv = read_file(folder.path() / "timing.csv");
  EXPECT_TRUE(contains(csv,
                       "stamp_s,localizer,stage,cpu_ms\n14.000000,a,update,4.000000\n"
                       "14.000000,a,match,0.500000\n14.000000,silent,update,0.000000\n"));
}

TEST(TimingSink, OfNoScanIsNull) {
  const TemporaryFolder folder;
  TimingSink(folder.path(), run_of({"a"})).finish(from_seconds(5.0), {});
  const Json timing = Json::parse(read_file(folder.path() / "timing.json"));
  EXPECT_TRUE(timing.at("realtime_factor").is_null());
  EXPECT_TRUE(timing.at("/localizers/a/update_ms/p99"_json_pointer).is_null());
}

}  // namespace
}  // namespace castaway::testbed
