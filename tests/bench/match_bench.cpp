/// How long the global search takes on a floor of like rooms.
#include <benchmark/benchmark.h>

#include "localization/matching/cascade_matcher.hpp"
#include "tests/bench/office_floor.hpp"

namespace {

using namespace castaway;
using namespace castaway::localization;

/// Arguments: algorithm, percentage of the beams that is blocked by people.
void match_floor(benchmark::State& state) {
  const OccupancyGrid floor = bench::office_floor();
  const double blocked = 0.01 * static_cast<double>(state.range(1));
  const ScanPoints points =
      bench::scan_of_floor(floor, {bench::kRoomX, bench::kRoomY, 0.4}, 0.02, blocked);
  MatcherConfig config;
  config.algorithm = static_cast<MatchAlgorithm>(state.range(0));
  const CascadeMatcher matcher(config, floor, DistanceField(floor, 5.0));
  for (auto _ : state) benchmark::DoNotOptimize(matcher.match(points));
  BranchAndBound search = matcher.search(points);
  while (!search.complete()) search.step(1000);
  state.counters["tiles"] = static_cast<double>(search.tiles_scored());
}

void match_window(benchmark::State& state) {
  const OccupancyGrid floor = bench::office_floor();
  const SE2 pose{bench::kRoomX, bench::kRoomY, 0.4};
  const ScanPoints points = bench::scan_of_floor(floor, pose, 0.02, 0.0);
  const CascadeMatcher matcher({}, floor, DistanceField(floor, 5.0));
  for (auto _ : state) benchmark::DoNotOptimize(matcher.match(points, MatchWindow{pose}));
}

void condition_map(benchmark::State& state) {
  const OccupancyGrid floor = bench::office_floor();
  const DistanceField distances(floor, 5.0);
  for (auto _ : state) benchmark::DoNotOptimize(CascadeMatcher({}, floor, distances));
}

BENCHMARK(match_floor)
    ->Name("Match")
    ->ArgNames({"exhaustive", "blocked_percent"})
    ->ArgsProduct({{0, 1}, {0, 40, 80}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(match_window)->Name("MatchWindow")->Unit(benchmark::kMillisecond);
BENCHMARK(condition_map)->Name("MatcherSetUp")->Unit(benchmark::kMillisecond);

}  // namespace
