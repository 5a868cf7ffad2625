#include "tools/batch/bench/localization_bench.hpp"

#include <gtest/gtest.h>

#include "localization/sensor/endpoint_model.hpp"
#include "tools/batch/bench/bench_scene.hpp"

namespace castaway::testbed {
namespace {

constexpr BenchEffort kQuick{1e-5, 1e-4, 3};

TEST(MedianCpuTime, GrowsWithTheWork) {
  volatile double sink = 0.0;
  const auto work = [&sink](int steps) {
    return [&sink, steps] {
      for (int i = 0; i < steps; ++i) sink = sink + 1.0;
    };
  };
  const double little = median_cpu_time(work(1000), {1e-4, 0.01, 11});
  const double much = median_cpu_time(work(100000), {1e-4, 0.01, 11});
  EXPECT_GT(little, 0.0);
  EXPECT_GT(much, 10.0 * little);
}

TEST(MedianCpuTime, RunsWhatTakesLongOnce) {
  int calls = 0;
  median_cpu_time([&calls] { ++calls; }, {1e-3, 0.0, 5});
  EXPECT_EQ(calls, 1);
}

TEST(BenchScene, IsAnOfficeWithItsScan) {
  const BenchScene scene = bench_scene();
  EXPECT_EQ(scene.grid.frame.width, 800);
  EXPECT_EQ(scene.grid.frame.height, 600);
  EXPECT_GT(scene.points.size(), 150U);
  const localization::EndpointModel model({}, scene.distances);
  EXPECT_GT(model.log_likelihood(scene.points, scene.T_map_base), -1.5);
  BenchSceneSpec crowded;
  crowded.blocked = 0.5;
  const BenchScene blocked = bench_scene(crowded);
  EXPECT_EQ(blocked.T_map_base, scene.T_map_base);
  int near = 0;
  for (std::size_t i = 0; i < blocked.scan.ranges.size(); ++i) {
    EXPECT_LE(blocked.scan.ranges[i], scene.scan.ranges[i]);
    near += blocked.scan.ranges[i] <= 1.0F ? 1 : 0;
  }
  EXPECT_GT(near, 60);
}

TEST(TimeSteps, TimesEveryStepBesideItsReference) {
  const std::vector<StepTime> steps = time_steps(kQuick);
  ASSERT_EQ(steps.size(), 6U);
  EXPECT_EQ(steps.front().step, "predict");
  EXPECT_EQ(steps.back().step, "whole update");
  for (const StepTime& time : steps) {
    EXPECT_GT(time.time_s, 0.0) << time.step;
    EXPECT_GT(time.plain_s, 0.0) << time.step;
    EXPECT_GE(time.items, 5.0 * 150) << time.step;
  }
}

TEST(TimeMatch, SearchesAnOffice) {
  const MatchTime time = time_match(10.0, 10.0, kQuick);
  EXPECT_EQ(time.width, 10.0);
  EXPECT_EQ(time.yaws, 120);
  EXPECT_EQ(time.points, 64);
  EXPECT_GT(time.branch_s, 0.0);
  EXPECT_GT(time.plain_s.value(), time.branch_s);
}

}  // namespace
}  // namespace castaway::testbed
