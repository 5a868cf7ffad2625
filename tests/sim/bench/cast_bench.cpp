// Ray casts per second: scans of 360 beams from random places in a hall of rotated boxes and
// people, by the scenes and by a loop over all shapes. Usage: cast_bench --benchmark_filter=Scan
#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include "sim/sensor/lidar.hpp"
#include "tests/sim/support/people_scene.hpp"

namespace {

using namespace castaway::sim;

constexpr int kBeams = 360;
constexpr double kRange = 12.0;  // [m]

std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kBeams;
    result.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return result;
}

Eigen::Vector3d place(Rng& rng) {
  const double x = draw_between(-9.0, 9.0, rng);
  return {x, draw_between(-9.0, 9.0, rng), 0.2};
}

void count_rays(benchmark::State& state) {
  state.counters["rays"] = benchmark::Counter(static_cast<double>(state.iterations()) * kBeams,
                                              benchmark::Counter::kIsRate);
}

/// Arguments: boxes, people.
void Scan(benchmark::State& state) {
  const RayScene scene(ray_primitives(hall(static_cast<int>(state.range(0)))));
  Rng rng(2);
  const MovingScene people(strollers(static_cast<int>(state.range(1)), rng));
  const Surroundings around(scene, people);
  const std::vector<Eigen::Vector3d> beams = directions();
  for (auto _ : state) {
    const Eigen::Vector3d origin = place(rng);
    double sum = 0.0;
    std::uint32_t guess = kNoPrimitive;
    for (const Eigen::Vector3d& direction : beams) {
      const auto hit = cast(around, {origin, direction}, kRange, guess);
      sum += hit ? hit->distance : kRange;
      guess = hit ? hit->primitive : guess;
    }
    benchmark::DoNotOptimize(sum);
  }
  count_rays(state);
}

void BruteForce(benchmark::State& state) {
  const auto primitives = ray_primitives(hall(static_cast<int>(state.range(0))));
  Rng rng(2);
  const auto people = strollers(static_cast<int>(state.range(1)), rng);
  const std::vector<Eigen::Vector3d> beams = directions();
  for (auto _ : state) {
    const Eigen::Vector3d origin = place(rng);
    double sum = 0.0;
    for (const Eigen::Vector3d& direction : beams) {
      const Ray ray{origin, direction};
      double nearest = kRange;
      for (const RayPrimitive& p : primitives) nearest = std::min(nearest, intersect(p, ray));
      for (const MovingBody& body : people) {
        for (const UprightPart& part : body.parts)
          nearest = std::min(nearest, intersect(part, ray));
      }
      sum += nearest;
    }
    benchmark::DoNotOptimize(sum);
  }
  count_rays(state);
}

void Update(benchmark::State& state) {
  Rng rng(2);
  const auto people = strollers(static_cast<int>(state.range(0)), rng);
  for (auto _ : state) {
    MovingScene scene(people);
    benchmark::DoNotOptimize(scene);
  }
}

BENCHMARK(Scan)->Args({60, 0})->Args({60, 20})->Args({60, 200})->Args({920, 0})->Args({920, 20});
BENCHMARK(BruteForce)->Args({60, 20})->Args({920, 20});
BENCHMARK(Update)->Arg(20)->Arg(200);

}  // namespace
