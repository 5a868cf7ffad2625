#include "tools/batch/bench/bench_filters.hpp"

#include "localization/filter/correct.hpp"
#include "localization/filter/predict.hpp"
#include "localization/filter/reseed.hpp"

namespace castaway::testbed {
namespace {

using namespace localization;

constexpr double kSpread = 0.1;      // [m]
constexpr double kSpreadYaw = 0.05;  // [rad]
const SE2 kStep{0.005, 0.0, 0.003};  // Motion in 10 ms.

PoseGaussian around(const BenchScene& scene) {
  const Eigen::Vector3d sigma(kSpread, kSpread, kSpreadYaw);
  return {scene.T_map_base, sigma.cwiseAbs2().asDiagonal()};
}

constexpr double kAll = FastFilters::kPopulations * FastFilters::kParticles;

}  // namespace

FastFilters::FastFilters(const BenchScene& scene)
    : scene_(&scene),
      endpoints_({}, scene.distances),
      rays_({}, scene.grid),
      evidence_({}, scene.grid, scene.distances),
      winner_(around(scene)),
      rng_(substream(1, "bench_filters")) {
  for (int k = 0; k < kPopulations; ++k) {
    populations_.push_back(draw_particles(winner_, kParticles, rng_));
  }
}

void FastFilters::predict() {
  const OdometryMotion motion(kStep, {});
  for (ParticleSet& set : populations_) localization::predict(set, motion, rng_);
}

void FastFilters::correct() {
  for (ParticleSet& set : populations_) localization::correct(set, endpoints_, scene_->points);
}

void FastFilters::correct_by_rays() {
  for (ParticleSet& set : populations_) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      set.log_weights[i] += rays_.evaluate(scene_->points, set.poses[i]).log_likelihood;
    }
  }
}

void FastFilters::reseed() {
  for (ParticleSet& set : populations_) {
    set = localization::reseed(set, kParticles, winner_, rng_);
  }
}

double FastFilters::evidence() const {
  double sum = 0.0;
  for (const ParticleSet& set : populations_) {
    sum += evidence_.evaluate(scene_->points, moments(set).mean).log_likelihood;
  }
  return sum;
}

double FastFilters::update() {
  predict();
  correct();
  const double result = evidence();
  reseed();
  return result;
}

double FastFilters::mean_log_weight() const {
  double sum = 0.0;
  for (const ParticleSet& set : populations_) {
    for (const double log_weight : set.log_weights) sum += log_weight;
  }
  return sum / kAll;
}

PlainFilters::PlainFilters(const BenchScene& scene)
    : scene_(&scene), scan_(plain_scan(scene.scan)), rng_(substream(1, "bench_filters")) {
  for (int k = 0; k < FastFilters::kPopulations; ++k) {
    std::vector<PlainParticle>& set = populations_.emplace_back();
    for (const SE2& p : draw_particles(around(scene), FastFilters::kParticles, rng_).poses) {
      set.push_back({p.x, p.y, p.yaw, 0.0});
    }
  }
}

void PlainFilters::predict() {
  for (auto& set : populations_) plain_predict(set, kStep, {}, rng_);
}

void PlainFilters::correct() {
  for (auto& set : populations_) {
    for (PlainParticle& p : set) p.log_weight += plain_endpoints({}, scene_->distances, scan_, p);
  }
}

void PlainFilters::correct_by_rays() {
  for (auto& set : populations_) {
    for (PlainParticle& p : set) {
      p.log_weight += plain_rays({}, scene_->grid, scan_, p).log_likelihood;
    }
  }
}

void PlainFilters::reseed() {
  for (auto& set : populations_) set = plain_reseed(set, kSpread, kSpreadYaw, rng_);
}

double PlainFilters::evidence() const {
  double sum = 0.0;
  for (const auto& set : populations_) {
    const SE2 mean = plain_mean(set);
    const PlainParticle at{mean.x, mean.y, mean.yaw, 0.0};
    sum += plain_evidence({}, scene_->grid, scene_->distances, scan_, at);
  }
  return sum;
}

double PlainFilters::update() {
  predict();
  correct();
  const double result = evidence();
  reseed();
  return result;
}

double PlainFilters::mean_log_weight() const {
  double sum = 0.0;
  for (const auto& set : populations_) {
    for (const PlainParticle& p : set) sum += p.log_weight;
  }
  return sum / kAll;
}

}  // namespace castaway::testbed
