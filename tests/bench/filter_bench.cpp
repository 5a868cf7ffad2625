/// How long the phases of the filter take for 5 populations of 200 particles, and correction
/// written without any thought of speed beside it.
#include <cmath>

#include <benchmark/benchmark.h>

#include "localization/filter/correct.hpp"
#include "localization/filter/predict.hpp"
#include "localization/filter/reseed.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "tests/bench/office_floor.hpp"

namespace {

using namespace castaway;
using namespace castaway::localization;

constexpr int kPopulations = 5;
constexpr int kParticles = 200;
const SE2 kPose{bench::kRoomX, bench::kRoomY, 0.4};

std::vector<ParticleSet> populations() {
  Rng rng = substream(1, "filter_bench");
  const Eigen::Matrix3d spread = Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal();
  std::vector<ParticleSet> sets;
  for (int k = 0; k < kPopulations; ++k) {
    const SE2 mean{kPose.x + 5.0 * k, kPose.y, kPose.yaw};
    sets.push_back(draw_particles(PoseGaussian(mean, spread), kParticles, rng));
  }
  return sets;
}

void count_particles(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kPopulations * kParticles);
}

void predict_all(benchmark::State& state) {
  std::vector<ParticleSet> sets = populations();
  Rng rng = substream(2, "filter_bench");
  const OdometryMotion motion({0.01, 0.0, 0.005}, {});
  for (auto _ : state) {
    for (ParticleSet& set : sets) predict(set, motion, rng);
  }
  count_particles(state);
}

void correct_all(benchmark::State& state) {
  const OccupancyGrid floor = bench::office_floor();
  const ScanPoints points = bench::scan_of_floor(floor, kPose, 0.02, 0.0);
  const EndpointModel model({}, DistanceField(floor, 5.0));
  std::vector<ParticleSet> sets = populations();
  for (auto _ : state) {
    for (ParticleSet& set : sets) correct(set, model, points);
  }
  benchmark::DoNotOptimize(sets);
  count_particles(state);
  state.counters["beams"] = static_cast<double>(points.size());
}

/// Log-likelihood of a scan straight from the formulas: sine, cosine and logarithm at every beam,
/// nearest cell of the distance field.
double plain_log_likelihood(const DistanceField& distances, const ScanPoints& points,
                            const SE2& T_map_base) {
  const EndpointConfig config;
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SE2 T_grid_base = distances.frame().T_map_grid.inverse() * T_map_base;
    const double heading = T_grid_base.yaw + std::atan2(points.y[i], points.x[i]);
    const double range = std::hypot(points.x[i], points.y[i]);
    const Eigen::Vector2d end(T_grid_base.x + range * std::cos(heading),
                              T_grid_base.y + range * std::sin(heading));
    sum += endpoint_log_likelihood(config, distances.at(end));
  }
  return config.independent_beams * sum / static_cast<double>(points.size());
}

void correct_plainly(benchmark::State& state) {
  const OccupancyGrid floor = bench::office_floor();
  const ScanPoints points = bench::scan_of_floor(floor, kPose, 0.02, 0.0);
  const DistanceField distances(floor, 5.0);
  std::vector<ParticleSet> sets = populations();
  for (auto _ : state) {
    for (ParticleSet& set : sets) {
      for (std::size_t i = 0; i < set.size(); ++i) {
        set.log_weights[i] += plain_log_likelihood(distances, points, set.poses[i]);
      }
    }
  }
  benchmark::DoNotOptimize(sets);
  count_particles(state);
}

void reseed_all(benchmark::State& state) {
  const std::vector<ParticleSet> sets = populations();
  Rng rng = substream(3, "filter_bench");
  const Eigen::Matrix3d spread = Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal();
  const PoseGaussian winner(kPose, spread);
  for (auto _ : state) {
    for (const ParticleSet& set : sets) {
      benchmark::DoNotOptimize(reseed(set, kParticles, winner, rng));
    }
  }
  count_particles(state);
}

BENCHMARK(predict_all)->Name("Predict")->Unit(benchmark::kMicrosecond);
BENCHMARK(correct_all)->Name("Correct")->Unit(benchmark::kMicrosecond);
BENCHMARK(correct_plainly)->Name("CorrectPlainReference")->Unit(benchmark::kMicrosecond);
BENCHMARK(reseed_all)->Name("Reseed")->Unit(benchmark::kMicrosecond);

}  // namespace
