#include "tools/live/live_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/build/build_localizers.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/scan_truth.hpp"
#include "tools/run/event_names.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

/// All that a run delivers, as numbers.
struct Delivered {
  std::vector<double> numbers;
  std::vector<std::string> events;

  void add(const SE2& pose) { numbers.insert(numbers.end(), {pose.x, pose.y, pose.yaw}); }
};

/// Writes into what must outlive it.
class DeliveredSink final : public RunSink {
 public:
  explicit DeliveredSink(Delivered& delivered) : delivered_(delivered) {}
  void on_event(const RunEvent& event) override {
    delivered_.events.push_back(std::to_string(event.stamp.count()) + " " +
                                names_of(event.what).kind + " " + names_of(event.what).detail);
  }
  void on_odometry(const OdometryFrame& frame) override {
    delivered_.add(frame.odometry.T_odom_base);
  }
  void on_scan(const ScanRecord& record) override {
    delivered_.add(record.true_pose.value().T_map_base);
    for (const float range : record.scan.ranges) delivered_.numbers.push_back(range);
    for (const LocalizerRecord& localizer : record.localizers) {
      if (localizer.estimate) delivered_.add(localizer.estimate->T_map_base);
    }
  }
  void finish(Stamp, const RunTiming&) override {}

 private:
  Delivered& delivered_;
};

std::vector<std::unique_ptr<RunSink>> sinks_into(Delivered& delivered) {
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<DeliveredSink>(delivered));
  return sinks;
}

LiveSinkMaker into(Delivered& delivered) {
  return [&delivered](const RunInfo&, const RosMap&, double) {
    return std::make_unique<DeliveredSink>(delivered);
  };
}

LoadedScenario live_lab(const std::string& more = "") {
  return read_scenario(YamlDocument::parse("world: lab\nlidar: {rate_hz: 10, range_max: 12}\n"
                                           "people: {count: 3}\nlocalizers: [mh_amcl, amcl]\n" +
                                               more,
                                           "live.yaml"),
                       data_root(), "live");
}

void play_until(LiveRun& run, double at_s) {
  while (localization::seconds(run.now()) < at_s && run.step()) {
  }
}

/// Plays a saved scenario as `castaway run` does.
Delivered replayed(const std::string& text) {
  const LoadedScenario loaded =
      read_scenario(YamlDocument::parse(text, "saved.yaml"), data_root(), "live");
  PreparedSimulation prepared = build_simulation(loaded.scenario, data_root());
  auto localizers = build_localizers(loaded.scenario.localizers,
                                     {prepared.map, {}, lidars_of(prepared.config.lidars), {}},
                                     loaded.scenario.seed);
  auto source = build_source(loaded.scenario, std::move(prepared.config));
  Delivered delivered;
  auto sinks = sinks_into(delivered);
  Loop(loop_config(loaded.scenario, *source->start_pose()), localizers, sinks).run(*source);
  return delivered;
}

TEST(LiveRun, WhatHandsDidIsRepeatedToTheBit) {
  SharedWorlds worlds;
  Delivered lived;
  LiveRun run(live_lab(), data_root(), worlds, into(lived));
  const std::vector<std::string> hands = {
      R"({"kidnap": {"kind": "teleport", "min_distance_m": 2}})",
      R"({"drive": {"v": 0.1, "w": 0.4}})",
      R"({"localizer": {"name": "amcl", "do": "relocalize"}})",
      R"({"fault": {"kind": "lidar-frozen", "for_s": 0.5}})",
      R"({"localizer": {"name": "mh_amcl", "do": "initialize", "pose": [0, 0, 0]}})",
      R"({"box": {"at": [6.5, -0.3], "yaw_deg": 30}})",
      R"({"people": {"at": [0, 1.85], "count": 2, "walk": true}})",
      R"({"kidnap": {"kind": "turn"}})",
      R"({"remove": {"name": "box-6"}})",
      R"({"cylinder": {"at": [6.5, -0.3], "radius": 0.2}})",
      R"({"drive": {}})",
      R"({"fault": {"kind": "odometry-scale", "for_s": 1, "scale": 1.3}})",
      R"({"kidnap": {"kind": "carry", "min_distance_m": 1, "lift_s": 0.2}})",
      R"({"localizer": {"name": "amcl", "do": "off"}})",
      R"({"localizer": {"name": "amcl", "do": "on"}})"};
  double at_s = 0.0;
  for (const std::string& hand : hands) {
    play_until(run, at_s += 0.733);
    run.add(hand);
  }
  play_until(run, at_s + 3.0);
  const Delivered again = replayed(run.saved());
  ASSERT_GT(again.numbers.size(), 10000U);
  lived.numbers.resize(std::min(lived.numbers.size(), again.numbers.size()));
  EXPECT_EQ(lived.numbers.size(), again.numbers.size());
  EXPECT_TRUE(lived.numbers == again.numbers);
  EXPECT_THAT(again.events, testing::Contains(HasSubstr("operator relocalize")));
  EXPECT_THAT(again.events, testing::Contains(HasSubstr("world box-6 taken away")));
  lived.events.resize(std::min(lived.events.size(), again.events.size()));
  EXPECT_EQ(lived.events, again.events);
}

TEST(LiveRun, EventsOfTheScenarioTakePlaceBesideThoseOfHands) {
  SharedWorlds worlds;
  Delivered lived;
  LiveRun run(
      live_lab("events: [{drive: {at_s: 2, v: 0.1}}, {kidnap: {at_s: 3, min_distance_m: 1}}]\n"),
      data_root(), worlds, into(lived));
  play_until(run, 1.0);
  run.add(R"({"drive": {"w": 0.5}})");
  run.add(R"({"kidnap": {"min_distance_m": 1}})");
  play_until(run, 5.0);
  const Delivered again = replayed(run.saved());
  ASSERT_LE(again.numbers.size(), lived.numbers.size() + 20);
  lived.numbers.resize(std::min(lived.numbers.size(), again.numbers.size()));
  EXPECT_TRUE(std::equal(lived.numbers.begin(), lived.numbers.end(), again.numbers.begin()));
}

TEST(LiveRun, SaysWhatIsWrongAndGoesOn) {
  SharedWorlds worlds;
  Delivered lived;
  LiveRun run(live_lab(), data_root(), worlds, into(lived));
  play_until(run, 0.5);
  const auto error_of = [&run](const std::string& event) -> std::string {
    try {
      run.add(event);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of("[]"), HasSubstr("an event is one kind"));
  EXPECT_THAT(error_of("not json"), HasSubstr("an event is one kind"));
  EXPECT_THAT(error_of(R"({"kidnap": {"pose": [900, 0, 0]}})"), HasSubstr("900"));
  EXPECT_THAT(error_of(R"({"kidnap": {"kind": "beam"}})"), HasSubstr("teleport"));
  EXPECT_THAT(error_of(R"({"kidnap": {"at_s": 3}})"), HasSubstr("leave 'at_s' out"));
  EXPECT_THAT(error_of(R"({"kidnap": {"poisson_s": 3}})"), HasSubstr("give one of"));
  EXPECT_THAT(error_of(R"({"fault": {"kind": "lidar-late", "for_s": 1, "lidar": "top"}})"),
              HasSubstr("no lidar 'top'"));
  EXPECT_THAT(error_of(R"({"localizer": {"name": "gmapping", "do": "off"}})"),
              HasSubstr("gmapping"));
  const std::string before = run.saved();
  play_until(run, 1.0);
  EXPECT_EQ(before.find("900"), std::string::npos);
  EXPECT_TRUE(run.step());
}

TEST(LiveRun, KnowsWhereEverythingIsBetweenScans) {
  SharedWorlds worlds;
  Delivered lived;
  LiveRun run(live_lab(), data_root(), worlds, into(lived));
  play_until(run, 2.055);
  const auto estimates = run.estimates();
  ASSERT_EQ(estimates.size(), 2U);
  EXPECT_LT(localization::distance(estimates[0].value(), run.true_pose().value()), 0.1);
}

}  // namespace
}  // namespace castaway::testbed
