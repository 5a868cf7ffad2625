#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tools/build/build_localizers.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// Records events and scans.
class Keeper final : public RunSink {
 public:
  void on_event(const RunEvent& event) override { events.push_back(event); }
  void on_odometry(const OdometryFrame& frame) override { odometry.push_back(frame); }
  void on_scan(const ScanRecord& record) override { records.push_back(record); }
  void finish(Stamp, const RunTiming&) override {}
  std::vector<RunEvent> events;
  std::vector<OdometryFrame> odometry;
  std::vector<ScanRecord> records;
};

/// Runs MH-AMCL and AMCL for 5 s in the lab with a fault from 1.5 to 2.5 s.
Keeper run_with(sim::FaultKind kind) {
  Scenario scenario;
  scenario.duration_s = 5.0;
  scenario.lidars.front().set("rate_hz", 10.0);
  scenario.localizers = {{"mh_amcl", localization::MhAmclConfig{}},
                         {"amcl", localization::AmclConfig{}}};
  sim::FaultSpec fault;
  fault.kind = kind;
  fault.at_s = 1.5;
  fault.mount_error = {0.1, 0.0, 0.1};
  scenario.events.simulated.faults = {fault};
  PreparedSimulation prepared = build_simulation(scenario, ".");
  auto localizers = build_localizers(scenario.localizers, {prepared.map}, 1);
  auto lidars = prepared.config.lidars;
  const Stamp duration = prepared.config.duration;
  SimulatorSource source(sim::Simulation(std::move(prepared.config), simulation_streams(1)),
                         std::move(lidars), duration);
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<Keeper>());
  Loop(loop_config(scenario, *source.start_pose()), localizers, sinks).run(source);
  return std::move(dynamic_cast<Keeper&>(*sinks.front()));
}

class EveryFault : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryFault, IsLoggedAndSurvived) {
  const auto kind = static_cast<sim::FaultKind>(GetParam());
  const Keeper run = run_with(kind);
  ASSERT_FALSE(run.events.empty());
  const EventNames names = names_of(run.events[0].what);
  EXPECT_EQ(names.kind, "fault on");
  EXPECT_EQ(names.detail, sim::to_string(kind));
  EXPECT_EQ(run.events[0].stamp, std::chrono::milliseconds(1500));
  const bool ends = kind != sim::FaultKind::kOdometryReset;
  EXPECT_EQ(run.events.size(), ends ? 2U : 1U);
  ASSERT_FALSE(run.records.empty());
  EXPECT_GT(run.records.back().stamp, std::chrono::milliseconds(4700));
  for (const LocalizerRecord& localizer : run.records.back().localizers) {
    EXPECT_TRUE(localizer.estimate.has_value()) << localizer.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, EveryFault,
                         testing::Range<std::size_t>(0, sim::kFaultNames.size()),
                         [](const auto& fault) {
                           std::string name = sim::kFaultNames[fault.param];
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// True if a stamp lies within the fault, excluding the duration of a scan at both ends.
template <typename Records, typename StampOf>
bool any_within(const Records& records, StampOf stamp_of) {
  return std::any_of(records.begin(), records.end(), [&](const auto& record) {
    return stamp_of(record) >= std::chrono::milliseconds(1500) &&
           stamp_of(record) < std::chrono::milliseconds(2500);
  });
}

TEST(Dropouts, DeliverNothing) {
  const Keeper blind = run_with(sim::FaultKind::kLidarDropout);
  EXPECT_FALSE(any_within(blind.records, [](const ScanRecord& r) { return r.stamp; }));
  const Keeper numb = run_with(sim::FaultKind::kOdometryDropout);
  const auto stamp = [](const OdometryFrame& frame) { return frame.odometry.stamp; };
  EXPECT_FALSE(any_within(numb.odometry, stamp));
  EXPECT_TRUE(any_within(blind.odometry, stamp));
}

TEST(WrongMount, IsToldWhileItLasts) {
  for (const ScanRecord& record : run_with(sim::FaultKind::kLidarMount).records) {
    const bool wrong = record.stamp >= std::chrono::milliseconds(1500) &&
                       record.stamp < std::chrono::milliseconds(2500);
    const double yaw_sine = record.scan.T_base_laser.linear()(1, 0);
    EXPECT_NEAR(yaw_sine, wrong ? std::sin(0.1) : 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace castaway::testbed
