#include "tests/bench/workbench/published_bench.hpp"

#include <memory>
#include <stdexcept>

#include "tools/base/process/cpu_clock.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/outputs/records/run_history.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

/// Scores all localizers when the run ends.
class ScoreSink final : public RunSink {
 public:
  ScoreSink(RunInfo info, std::vector<VariantScore>& scores)
      : history_(std::move(info)), scores_(scores) {}

  void on_event(const RunEvent& event) override { history_.add(event); }
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override { history_.add(record); }
  /// Throws std::runtime_error if the run is void, since a void run must not be scored.
  void finish(Stamp end, const RunTiming&) override {
    if (const auto found = void_run(history_.events)) {
      throw std::runtime_error("a run is void: " + describe(*found));
    }
    for (std::size_t i = 0; i < scores_.size(); ++i) scores_[i].add(history_.metrics(i, end));
  }

 private:
  RunHistory history_;
  std::vector<VariantScore>& scores_;
};

std::vector<NamedLocalizer> build(const std::vector<PublishedVariant>& variants, const RosMap& map,
                                  std::uint64_t seed) {
  std::vector<NamedLocalizer> localizers;
  for (const PublishedVariant& variant : variants) {
    // One name for all variants, since the stream of random numbers depends on it.
    std::vector<NamedLocalizer> one = build_localizers({{"variant", variant.config}}, {map}, seed);
    one.front().name = variant.name;
    localizers.push_back(std::move(one.front()));
  }
  return localizers;
}

void play_variants(const Scenario& scenario, const std::filesystem::path& base,
                   const std::vector<PublishedVariant>& variants,
                   std::vector<VariantScore>& scores) {
  PreparedSimulation prepared = build_simulation(scenario, base);
  std::vector<NamedLocalizer> localizers = build(variants, prepared.map, scenario.seed);
  RunInfo info;
  info.known_start = scenario.start.known;
  for (const PublishedVariant& variant : variants) info.localizers.push_back(variant.name);
  const std::vector<sim::LidarConfig> lidars = prepared.config.lidars;
  const Stamp duration = prepared.config.duration;
  SimulatorSource source(sim::Simulation(std::move(prepared.config),
                                         simulation_streams(scenario.seed), thread_cpu_time),
                         lidars, duration);
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<ScoreSink>(std::move(info), scores));
  Loop(loop_config(scenario, *source.start_pose()), localizers, sinks).run(source);
}

}  // namespace

std::vector<VariantScore> play_variants(Scenario scenario, const std::filesystem::path& base,
                                        const std::vector<PublishedVariant>& variants, int seeds,
                                        const std::function<void()>& on_run) {
  scenario.drive.by = "truth";
  std::vector<VariantScore> scores;
  for (const PublishedVariant& variant : variants) scores.emplace_back().name = variant.name;
  for (int k = 0; k < seeds; ++k) {
    play_variants(scenario, base, variants, scores);
    ++scenario.seed;
    on_run();
  }
  return scores;
}

}  // namespace castaway::testbed
