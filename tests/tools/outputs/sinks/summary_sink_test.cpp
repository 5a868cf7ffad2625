#include "tools/outputs/sinks/summary_sink.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/formats/csv.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using localization::from_seconds;

/// Plays 20 s of one localizer with a kidnap at 4.5 s: alarm at 5 s and 6 s, right again from 7 s
/// on.
void play(SummarySink& sink) {
  for (int t = 0; t < 20; ++t) {
    if (t == 5) sink.on_event(kidnap_to(4.5));
    ScanRecord record = record_at(t, {"a"});
    if (t >= 5) record.true_pose->T_map_base.y = 4.0;
    if (t >= 7) record.localizers[0].estimate->T_map_base.y = 4.0;
    record.localizers[0].estimate->lost = t == 5 || t == 6;
    sink.on_scan(record);
  }
  sink.finish(from_seconds(20.0), {});
}

TEST(SummarySink, KnowsTheWayWithoutALocalizer) {
  const TemporaryFolder folder;
  SummarySink sink(folder.path(), run_of({}));
  for (int t = 0; t <= 20; ++t) sink.on_scan(record_at(t, {}));
  sink.finish(from_seconds(20.0), {});
  const Json summary = Json::parse(read_file(folder.path() / "summary.json"));
  EXPECT_NEAR(summary.at("distance_m").get<double>(), 2.0, 1e-9);
  EXPECT_TRUE(summary.at("localizers").empty());
}

TEST(SummarySink, TellsWhereOnlyEverySecondScanIsScored) {
  const TemporaryFolder folder;
  SummarySink sink(folder.path(), run_of({"a"}), 100);
  for (int i = 0; i <= 100; ++i) sink.on_scan(record_at(0.1 * i, {"a"}));
  sink.finish(from_seconds(10.0), {});
  EXPECT_EQ(Json::parse(read_file(folder.path() / "summary.json")).at("scored_every"), 2);
}

TEST(SummarySink, SaysWhatTheRunAmountsTo) {
  const TemporaryFolder folder;
  SummarySink sink(folder.path(), run_of({"a"}));
  play(sink);
  const Json summary = Json::parse(read_file(folder.path() / "summary.json"));
  EXPECT_EQ(summary.at("castaway"), CASTAWAY_VERSION);
  EXPECT_EQ(summary.at("metrics_version"), kMetricsVersion);
  EXPECT_EQ(summary.at("scenario"), "a-scenario");
  EXPECT_EQ(summary.at("world"), "a-world");
  EXPECT_EQ(summary.at("robot"), "a-robot");
  EXPECT_EQ(summary.at("seed"), 7);
  EXPECT_EQ(summary.at("duration_s"), 20.0);
  EXPECT_EQ(summary.at("distance_m"), 1.9);  // without the kidnap's jump
  EXPECT_EQ(summary.at("collisions"), 0);
  const Json& recovery = summary.at("/localizers/a/recovery"_json_pointer);
  EXPECT_EQ(recovery.at("recovered"), 1);
  EXPECT_EQ(recovery.at("/time_s/mean"_json_pointer), 2.6);  // delivered at 7.1 s
  EXPECT_EQ(summary.at("/localizers/a/alarm/detection_delay_s/mean"_json_pointer), 0.6);
}

TEST(SummarySink, SaysHowTheWorldDiffersFromItsMap) {
  const TemporaryFolder folder;
  RunInfo info = run_of({"a"});
  info.difference = MapDifference{0.25, 3, 2, 0, 1, 4};
  SummarySink sink(folder.path(), info);
  play(sink);
  const Json summary = Json::parse(read_file(folder.path() / "summary.json"));
  EXPECT_EQ(summary.at("difference"), (Json{{"beams", 0.25},
                                            {"moved", 3},
                                            {"removed", 2},
                                            {"opened", 0},
                                            {"closed", 1},
                                            {"added", 4}}));
}

TEST(SummarySink, SaysHowTheRunIsOtherwiseThanWhatItSimulates) {
  const TemporaryFolder folder;
  RunInfo info = run_of({"a"});
  info.notes = {"the robot moves by mecanum wheels"};
  SummarySink sink(folder.path(), info);
  play(sink);
  const Json summary = Json::parse(read_file(folder.path() / "summary.json"));
  EXPECT_EQ(summary.at("notes"), Json::array({"the robot moves by mecanum wheels"}));
}

TEST(SummarySink, WritesEventsByTheTimeOfTheirAnswers) {
  const TemporaryFolder folder;
  SummarySink sink(folder.path(), run_of({"a"}));
  play(sink);
  EXPECT_EQ(read_file(folder.path() / "events.csv"),
            "stamp_s,kind,detail,localizer,from_x_m,from_y_m,from_yaw_rad,to_x_m,to_y_m,to_yaw_rad,"
            "time_s,distance_m\n"
            "4.500000,kidnap,teleport,,0.450000,0.000000,0.000000,0.450000,4.000000,0.000000,,\n"
            "5.100000,alarm on,,a,0.500000,4.000000,0.000000,,,,,\n"
            "7.100000,alarm off,,a,0.700000,4.000000,0.000000,,,,,\n"
            "7.100000,recovery,from kidnap,a,,,,,,,2.600000,0.200000\n");
}

TEST(SummarySink, TellsAnUnknownStartFromAKidnap) {
  const TemporaryFolder folder;
  RunInfo info = run_of({"a"});
  info.known_start = false;
  SummarySink sink(folder.path(), info);
  for (int t = 1; t < 20; ++t) sink.on_scan(record_at(t, {"a"}));
  sink.finish(from_seconds(20.0), {});
  EXPECT_TRUE(contains(read_file(folder.path() / "events.csv"),
                       "\n1.100000,recovery,from unknown start,a,,,,,,,0.100000,0.000000\n"));
  const Json summary = Json::parse(read_file(folder.path() / "summary.json"));
  EXPECT_EQ(summary.at("known_start"), false);
  EXPECT_EQ(summary.at("duration_s"), 19.0);
}

TEST(SummarySink, CountsCollisions) {
  const TemporaryFolder folder;
  SummarySink sink(folder.path(), run_of({"a"}));
  sink.on_event({from_seconds(1.0), sim::Collision{"wall"}});
  sink.on_event({from_seconds(2.0), sim::Collision{"wall, \"red\""}});
  sink.finish(from_seconds(5.0), {});
  EXPECT_EQ(Json::parse(read_file(folder.path() / "summary.json")).at("collisions"), 2);
  EXPECT_EQ(read_csv(folder.path() / "events.csv").rows[1][2], "wall, \"red\"");
}

TEST(SummarySink, OfNothingIsNull) {
  const TemporaryFolder folder;
  SummarySink(folder.path(), run_of({"a"})).finish(Stamp{}, {});
  const Json summary = Json::parse(read_file(folder.path() / "summary.json"));
  EXPECT_TRUE(summary.at("distance_m").is_null());
  EXPECT_EQ(summary.at("duration_s"), 0.0);
  EXPECT_TRUE(summary.at("/localizers/a/position_error_m/mean"_json_pointer).is_null());
}

}  // namespace
}  // namespace castaway::testbed
