/// Times the global search on a floor of similar rooms.
#include <benchmark/benchmark.h>

#include "localization/matching/cascade_matcher.hpp"
#include "localization/paper/paper_cascade.hpp"
#include "tests/localization/paper/naive_rays.hpp"
#include "tools/batch/bench/bench_scene.hpp"

namespace {

using namespace castaway;
using namespace castaway::localization;

/// Arguments: algorithm, percentage of beams blocked by people.
void match_floor(benchmark::State& state) {
  testbed::BenchSceneSpec spec;
  spec.blocked = 0.01 * static_cast<double>(state.range(1));
  const testbed::BenchScene scene = testbed::bench_scene(spec);
  MatcherConfig config;
  config.algorithm = static_cast<MatchAlgorithm>(state.range(0));
  const CascadeMatcher matcher(config, scene.grid, scene.distances);
  for (auto _ : state) benchmark::DoNotOptimize(matcher.match(scene.points));
  StagedSearch search = matcher.search(scene.points);
  while (!search.complete()) search.step(1000);
  state.counters["tiles"] = static_cast<double>(search.tiles_scored());
}

void match_window(benchmark::State& state) {
  const testbed::BenchScene scene = testbed::bench_scene();
  const CascadeMatcher matcher({}, scene.grid, scene.distances);
  const MatchWindow window{scene.T_map_base};
  for (auto _ : state) benchmark::DoNotOptimize(matcher.match(scene.points, window));
}

void match_as_the_paper(benchmark::State& state) {
  const testbed::BenchScene scene = testbed::bench_scene();
  const PaperCascade cascade({}, {}, scene.grid);
  for (auto _ : state) benchmark::DoNotOptimize(cascade.match(scene.points));
}

void match_as_the_paper_naively(benchmark::State& state) {
  const testbed::BenchScene scene = testbed::bench_scene();
  const double sigma = RayLocalConfig{}.sigma;
  for (auto _ : state) {
    const auto nodes = test::naive_cascade({}, sigma, scene.grid, scene.points);
    benchmark::DoNotOptimize(test::distinct({}, nodes));
  }
}

void condition_map(benchmark::State& state) {
  const testbed::BenchScene scene = testbed::bench_scene();
  for (auto _ : state) {
    benchmark::DoNotOptimize(CascadeMatcher({}, scene.grid, scene.distances));
  }
}

BENCHMARK(match_floor)
    ->Name("Match")
    ->ArgNames({"exhaustive", "blocked_percent"})
    ->ArgsProduct({{0, 1}, {0, 40, 80}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(match_window)->Name("MatchWindow")->Unit(benchmark::kMillisecond);
BENCHMARK(match_as_the_paper)->Name("PaperMatch/ours")->Unit(benchmark::kMillisecond);
BENCHMARK(match_as_the_paper_naively)->Name("PaperMatch/naive")->Unit(benchmark::kMillisecond);
BENCHMARK(condition_map)->Name("MatcherSetUp")->Unit(benchmark::kMillisecond);

}  // namespace
