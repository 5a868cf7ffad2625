#include "localization/amcl/amcl_filter.hpp"

#include <cmath>
#include <stdexcept>

#include "localization/filter/kld_resample.hpp"
#include "localization/filter/predict.hpp"

namespace castaway::localization {
namespace {

Eigen::Matrix3d start_covariance(const InitialSpread& s, const PoseWithCovariance& start) {
  if (!start.covariance.isZero(0.0)) return start.covariance;
  return Eigen::Vector3d(s.sigma_m * s.sigma_m, s.sigma_m * s.sigma_m, s.sigma_yaw * s.sigma_yaw)
      .asDiagonal();
}

}  // namespace

AmclFilter::AmclFilter(const AmclConfig& config, const OccupancyGrid& map, Rng rng)
    : kld_(config.kld),
      initial_(config.initial),
      free_space_(map),
      averages_(config.recovery),
      rng_(rng) {
  if (free_space_.empty()) throw std::invalid_argument("map has no free cell to start on");
}

void AmclFilter::start(const std::optional<PoseWithCovariance>& start) {
  const int count = kld_.max_particles;
  if (start) {
    const PoseGaussian gaussian(start->T_map_base, start_covariance(initial_, *start));
    particles_ = draw_particles(gaussian, count, rng_);
  } else {
    particles_ = {};
    for (int i = 0; i < count; ++i) particles_.poses.push_back(free_space_.sample(rng_));
    particles_.log_weights.assign(particles_.poses.size(), 0.0);
  }
  averages_.reset();
}

void AmclFilter::predict(const DifferentialMotion& motion) {
  localization::predict(particles_, motion, rng_);
}

void AmclFilter::weigh(const std::vector<double>& log_weights) {
  const std::vector<double> before = normalized_weights(particles_);
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    total += before[i] * std::exp(log_weights[i]);
    particles_.log_weights[i] += log_weights[i];
  }
  averages_.add(total / static_cast<double>(particles_.size()));
}

void AmclFilter::resample() {
  const double random_share = averages_.random_share();
  if (random_share > 0.0) averages_.reset();
  particles_ = kld_resample(particles_, kld_, free_space_, random_share, rng_);
}

}  // namespace castaway::localization
