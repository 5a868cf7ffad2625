/// Times the phases of the filter for 5 populations of 200 particles and 180 beams, beside an
/// unoptimised reference implementation.
#include <benchmark/benchmark.h>

#include "tools/batch/bench/bench_filters.hpp"

namespace {

using namespace castaway::testbed;

/// Times a step on its own filter.
template <typename Filters, typename Step>
void time_step(benchmark::State& state, Step step) {
  const BenchScene scene = bench_scene();
  Filters filters(scene);
  for (auto _ : state) step(filters);
  benchmark::DoNotOptimize(filters.mean_log_weight());
  state.SetItemsProcessed(state.iterations() * FastFilters::kPopulations * FastFilters::kParticles);
  state.counters["beams"] = static_cast<double>(scene.points.size());
}

template <typename Step>
void add(const std::string& name, Step step) {
  benchmark::RegisterBenchmark((name + "/ours").c_str(), [=](benchmark::State& state) {
    time_step<FastFilters>(state, step);
  })->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark((name + "/plain").c_str(), [=](benchmark::State& state) {
    time_step<PlainFilters>(state, step);
  })->Unit(benchmark::kMicrosecond);
}

const bool kAdded = [] {
  add("Predict", [](auto& filters) { filters.predict(); });
  add("Correct", [](auto& filters) { filters.correct(); });
  add("CorrectByRays", [](auto& filters) { filters.correct_by_rays(); });
  add("Evidence", [](auto& filters) { benchmark::DoNotOptimize(filters.evidence()); });
  add("Reseed", [](auto& filters) { filters.reseed(); });
  add("WholeUpdate", [](auto& filters) { benchmark::DoNotOptimize(filters.update()); });
  return true;
}();

}  // namespace
