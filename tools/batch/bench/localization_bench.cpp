#include "tools/batch/bench/localization_bench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "castaway/stamp.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/batch/bench/bench_filters.hpp"
#include "tools/batch/bench/plain_match.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

/// CPU time of `calls` calls [s].
double time_of(const std::function<void()>& body, int calls) {
  const std::chrono::nanoseconds begin = thread_cpu_time();
  for (int i = 0; i < calls; ++i) body();
  return localization::seconds(thread_cpu_time() - begin);
}

using namespace localization;

/// Prevents the compiler from optimising a result away.
void keep(double value) { [[maybe_unused]] volatile double sink = value; }

/// Times one step of both implementations. The filters are copied so that no step affects another.
template <typename Step>
StepTime time_step(const std::string& name, FastFilters fast, PlainFilters plain,
                   const BenchEffort& effort, Step step) {
  StepTime time;
  time.step = name;
  time.time_s = median_cpu_time([&] { step(fast); }, effort);
  time.plain_s = median_cpu_time([&] { step(plain); }, effort);
  time.items = FastFilters::kPopulations * FastFilters::kParticles;
  time.item = "particles";
  return time;
}

StepTime per_beam(StepTime time, double poses, const BenchScene& scene) {
  time.items = poses * static_cast<double>(scene.points.size());
  time.item = "particle beams";
  return time;
}

MatchTime time_search(const MatcherConfig& config, const BenchScene& scene,
                      const BenchEffort& effort) {
  MatcherConfig exhaustive = config;
  exhaustive.algorithm = MatchAlgorithm::kExhaustive;
  const CascadeMatcher fast(config, scene.grid, scene.distances);
  const CascadeMatcher all(exhaustive, scene.grid, scene.distances);
  MatchTime time;
  time.width = scene.grid.frame.width * scene.grid.frame.resolution;
  time.height = scene.grid.frame.height * scene.grid.frame.resolution;
  time.cell = config.field.resolution;
  time.yaws = static_cast<int>(std::lround(2.0 * std::numbers::pi / config.yaw_step));
  time.points = config.points;
  time.branch_s = median_cpu_time([&] { keep(fast.match(scene.points).at(0).score); }, effort);
  time.exhaustive_s = median_cpu_time([&] { keep(all.match(scene.points).at(0).score); }, effort);
  return time;
}

BenchScene office(double width, double height) {
  BenchSceneSpec spec;
  spec.width = width;
  spec.height = height;
  return bench_scene(spec);
}

}  // namespace

double median_cpu_time(const std::function<void()>& body, const BenchEffort& effort) {
  const double first = time_of(body, 1);
  if (first > effort.total_s) return first;
  const double wanted = effort.sample_s / std::max(first, 1e-7);
  const int calls = std::max(1, static_cast<int>(std::min(wanted, 1e6)));
  std::vector<double> samples;
  double spent = 0.0;
  while (samples.empty() ||
         (spent < effort.total_s && samples.size() < static_cast<std::size_t>(effort.samples))) {
    const double time = time_of(body, calls);
    spent += time;
    samples.push_back(time / calls);
  }
  return statistics(std::move(samples))->median;
}

std::vector<StepTime> time_steps(const BenchEffort& effort) {
  const BenchScene scene = bench_scene();
  const FastFilters fast(scene);
  const PlainFilters plain(scene);
  const auto time = [&](const char* name, auto step) {
    return time_step(name, fast, plain, effort, step);
  };
  constexpr double kAll = FastFilters::kPopulations * FastFilters::kParticles;
  return {
      time("predict", [](auto& filter) { filter.predict(); }),
      per_beam(time("correct, end points", [](auto& filter) { filter.correct(); }), kAll, scene),
      per_beam(time("correct, rays", [](auto& filter) { filter.correct_by_rays(); }), kAll, scene),
      per_beam(time("evidence", [](auto& filter) { keep(filter.evidence()); }),
               FastFilters::kPopulations, scene),
      time("reseed", [](auto& filter) { filter.reseed(); }),
      per_beam(time("whole update", [](auto& filter) { keep(filter.update()); }), kAll, scene),
  };
}

MatchTime time_match(double width, double height, const BenchEffort& effort) {
  const BenchScene scene = office(width, height);
  const MatcherConfig config;
  MatchTime time = time_search(config, scene, effort);
  const PlainScan scan = plain_scan(scene.scan);
  time.plain_s = median_cpu_time(
      [&] { keep(plain_match(config, scene.grid, scene.distances, scan).score); }, effort);
  return time;
}

MatchTime time_fine_match(double width, double height, const BenchEffort& effort) {
  const BenchScene scene = office(width, height);
  MatcherConfig config;
  config.field.resolution = scene.grid.frame.resolution;
  config.yaw_step = std::numbers::pi / 180.0;
  config.points = 96;
  return time_search(config, scene, effort);
}

}  // namespace castaway::testbed
