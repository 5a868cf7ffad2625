// What lock step costs castaway for a scan of 360 beams and five readings of odometry, beyond the
// localizer's own time. The time is the CPU time of castaway's thread.
#include <benchmark/benchmark.h>

#include <numbers>

#include "tools/base/process/cpu_clock.hpp"
#include "tools/build/foreign/library_localizer.hpp"
#include "tools/build/foreign/program_localizer.hpp"

namespace castaway::testbed {
namespace {

LaserScan scan_of_360_beams() {
  LaserScan scan;
  scan.angle_min = -std::numbers::pi;
  scan.angle_increment = 2.0 * std::numbers::pi / 360.0;
  scan.range_max = 12.0;
  for (int i = 0; i < 360; ++i) scan.ranges.push_back(1.0F + 0.0123457F * static_cast<float>(i));
  return scan;
}

Greeting greeting() {
  Greeting greeting{"bench", 1, {"map", 200, 200, 0.05, 0.0, 0.0, 0.0, {}}, "", {}};
  greeting.map.cells.assign(40000, 0);
  greeting.lidars = {lidar_facts(scan_of_360_beams())};
  return greeting;
}

void play(localization::Localizer& localizer, benchmark::State& state) {
  LaserScan scan = scan_of_360_beams();
  localizer.initialize(localization::PoseWithCovariance{});
  Stamp now{};
  for (auto _ : state) {
    const auto begin = thread_cpu_time();
    for (int i = 0; i < 5; ++i) {
      now += std::chrono::milliseconds(20);
      localizer.on_odometry({now, {1e-9 * static_cast<double>(now.count()), 0.1234567, 0.01}});
    }
    scan.stamp = now;
    localizer.on_scan(scan);
    benchmark::DoNotOptimize(localizer.estimate());
    state.SetIterationTime(seconds(thread_cpu_time() - begin));
  }
}

void LockStepOfAProgram(benchmark::State& state) {
  const ProgramConfig config{
      {CASTAWAY_PROGRAM, "serve", "library:" CASTAWAY_DEAD_RECKONING}, "{}", 10.0, 60.0, {}};
  ProgramLocalizer localizer(config, greeting(), {});
  play(localizer, state);
  (void)localizer.finish();
}
BENCHMARK(LockStepOfAProgram)->UseManualTime()->Unit(benchmark::kMicrosecond);

void LockStepOfALibrary(benchmark::State& state) {
  LibraryLocalizer localizer({CASTAWAY_DEAD_RECKONING, "{}", {}}, greeting());
  play(localizer, state);
}
BENCHMARK(LockStepOfALibrary)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace castaway::testbed
