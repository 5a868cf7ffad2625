/// Times the global search over the four levels of 40 x 60 m of the car park, which look alike.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "localization/geometry/random.hpp"
#include "localization/matching/stack_matcher.hpp"
#include "tests/localization/matching/search_case.hpp"
#include "tools/build/map3d/map3d_files.hpp"

namespace {

using namespace castaway;
using namespace castaway::localization;
using test::uniform;

const Eigen::Vector3d kLidarAt{0.0, 0.0, 0.13};  // [m] In base.
constexpr double kMaxRange = 30.0;               // [m]

/// Surveyed once, by the program.
const Volume& car_park() {
  static const Volume volume = [] {
    const auto file = std::filesystem::temp_directory_path() / "castaway-bench-car-park.map3d";
    const std::string survey = CASTAWAY_PROGRAM " map car-park --out '" + file.string() + "'";
    if (std::system((survey + " >/dev/null").c_str()) != 0) {
      throw std::runtime_error(survey + ": failed");
    }
    testbed::Map3d map = testbed::read_map3d_file(file, {});
    std::filesystem::remove(file);
    return Volume(map.voxels, std::move(map.ground), {});
  }();
  return volume;
}

/// A place drawn from all ground.
SE2 draw_place(const Atlas& atlas, Rng& rng) {
  const GridFrame& frame = atlas.frame();
  for (;;) {
    const Eigen::Vector2i cell(static_cast<int>(uniform(0.0, frame.width, rng)),
                               static_cast<int>(uniform(0.0, frame.height, rng)));
    if (!atlas.is_own(cell)) continue;
    const SE2 T_grid_base{frame.centre_of(cell).x(), frame.centre_of(cell).y(),
                          uniform(-std::numbers::pi, std::numbers::pi, rng)};
    const SE2 T_atlas_base = frame.T_map_grid * T_grid_base;
    if (car_park().lift(T_atlas_base)) return T_atlas_base;
  }
}

/// [m] To the first surface; nothing within the range of the lidar.
std::optional<double> range_of(const Eigen::Isometry3d& T_map_base,
                               const Eigen::Vector3d& direction) {
  for (double r = 0.2; r < kMaxRange;) {
    const Eigen::Vector3d p_map = T_map_base * (kLidarAt + r * direction);
    const double clear = car_park().surfaces().at(p_map.cast<float>());
    if (clear <= 0.02) return r;
    r += std::max(0.01, 0.5 * clear);
  }
  return std::nullopt;
}

/// Points of 90 beams of a planar lidar; with the direction up, as an IMU knows it.
ScanPoints scan_from(const SE2& T_atlas_base, bool knows_up) {
  const Eigen::Isometry3d T_map_base = car_park().lift(T_atlas_base)->T_map_base;
  ScanPoints points;
  for (int beam = 0; beam < 90; ++beam) {
    const double angle = 2.0 * std::numbers::pi * beam / 90.0;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
    if (const auto r = range_of(T_map_base, direction)) {
      Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();
      T_base_laser.translation() = kLidarAt;
      append_beam(points, T_base_laser, *r * direction);
    }
  }
  if (knows_up) points.up = T_map_base.linear().row(2).transpose().cast<float>();
  return points;
}

/// One scan after the other from places on all levels. Argument: whether up is known.
void match_levels(benchmark::State& state) {
  Rng rng = substream(1, "stack_match_bench");
  const StackMatcher matcher(MatcherConfig{}, car_park());
  std::vector<ScanPoints> scans;
  for (int i = 0; i < 100; ++i) {
    scans.push_back(scan_from(draw_place(car_park().atlas(), rng), state.range(0) == 1));
  }
  double slowest = 0.0;
  std::size_t next = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(matcher.match(scans[next++ % scans.size()]));
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    slowest = std::max(slowest, took.count());
  }
  state.counters["slowest_ms"] = slowest;
}
BENCHMARK(match_levels)
    ->Name("MatchLevels")
    ->ArgName("up")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond);

}  // namespace
