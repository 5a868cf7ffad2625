#include "tools/run/metrics/metric_paths.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "castaway/stamp.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/outputs/sinks/summary_sink.hpp"
#include "tools/outputs/sinks/timing_sink.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

TEST(MetricTable, HasEveryFigureByItsKeys) {
  const Json summary = Json::parse(R"({"castaway": "0.1.0", "seed": 3, "collisions": 2,
    "driving": {"emergency stop": 1}, "list": [1, 2], "known_start": true,
    "localizers": {"a.b": {"recovery": {"success": 0.5, "time_s": {"mean": null}}}}})");
  const MetricTable expected{{"collisions", 2.0},
                             {"driving.emergency_stop", 1.0},
                             {"a.b.recovery.success", 0.5},
                             {"a.b.recovery.time_s.mean", std::nullopt}};
  EXPECT_EQ(metric_table(summary), expected);
}

TEST(MetricTable, HasTheTimingUnderItsName) {
  const MetricTable table = metric_table(
      Json::object(), Json::parse(R"({"localizers": {"a": {"update_ms": {"max": 2}}}})"));
  EXPECT_EQ(table, (MetricTable{{"timing.localizers.a.update_ms.max", 2.0}}));
}

/// The metrics of a run are known before it is made.
TEST(KnownMetrics, AreThoseThatARunHas) {
  const TemporaryFolder folder;
  RunInfo info = run_of({"mh_amcl", "amcl"});
  info.difference = MapDifference{};
  SummarySink summary(folder.path(), info);
  TimingSink timing(folder.path(), info);
  ScanRecord record = record_at(1.0, info.localizers);
  record.people.people.push_back({});
  for (RunSink* sink : {static_cast<RunSink*>(&summary), static_cast<RunSink*>(&timing)}) {
    sink->on_scan(record);
    sink->finish(localization::from_seconds(2.0), {});
  }
  const MetricTable table = metric_table(Json::parse(read_file(folder.path() / "summary.json")),
                                         Json::parse(read_file(folder.path() / "timing.json")));
  const std::vector<std::string> known = known_metrics(info.localizers);
  for (const auto& [name, value] : table) {
    if (name.ends_with("_interval")) continue;
    EXPECT_TRUE(std::find(known.begin(), known.end(), name) != known.end()) << name;
  }
  for (const std::string& name : known) {
    if (name.starts_with("timing.cpu_s")) continue;  // only for stages that ran
    EXPECT_TRUE(table.contains(name)) << name;
  }
}

}  // namespace
}  // namespace castaway::testbed
