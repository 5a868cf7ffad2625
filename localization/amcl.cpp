#include "localization/amcl.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::localization {
namespace {

/// The beams that AMCL takes: every `step`-th by index, all as if taken at the scan's stamp.
LaserScan thinned(const LaserScan& scan, int max_beams) {
  LaserScan thin = scan;
  const auto count = static_cast<int>(scan.ranges.size());
  const int step = std::max(1, (count - 1) / std::max(1, max_beams - 1));
  thin.ranges.clear();
  for (int i = 0; i < count; i += step) {
    thin.ranges.push_back(scan.ranges[static_cast<std::size_t>(i)]);
  }
  thin.angle_increment = scan.angle_increment * step;
  thin.time_increment = Stamp::zero();
  return thin;
}

}  // namespace

void validate(const AmclConfig& config) {
  const auto require = [](bool condition, const char* text) {
    if (!condition) throw std::invalid_argument(text);
  };
  for (const double alpha :
       {config.motion.alpha1, config.motion.alpha2, config.motion.alpha3, config.motion.alpha4,
        config.recovery.alpha_slow, config.recovery.alpha_fast, config.sensor.z_hit,
        config.sensor.z_rand, config.update_min_d, config.update_min_a}) {
    require(alpha >= 0.0, "alphas, z_hit, z_rand, update_min_d, update_min_a must not be negative");
  }
  require(config.sensor.sigma_hit > 0.0, "sigma_hit must be positive");
  require(config.sensor.max_distance > 0.0, "max_distance must be positive");
  require(config.kld.error > 0.0, "the error of KLD-sampling must be positive");
  require(config.kld.min_particles >= 1 && config.kld.max_particles >= config.kld.min_particles,
          "particles: need 1 <= min_particles <= max_particles");
  require(config.max_beams >= 2, "max_beams must be at least 2");
  require(config.max_range > 0.0, "max_range must be positive");
}

Amcl::Amcl(const AmclConfig& config, const OccupancyGrid& map, std::uint64_t seed, StageClock clock)
    : config_((validate(config), config)),
      field_(config.sensor, (validate(map), map)),
      free_space_(map),
      rng_(substream(seed, "amcl")),
      timer_(std::move(clock)),
      T_odom_base_(config.buffer),
      averages_(config.recovery) {
  if (free_space_.empty()) throw std::invalid_argument("map has no free cell to start on");
  initialize(std::nullopt);
}

void Amcl::initialize(const std::optional<PoseWithCovariance>& start) {
  const int count = config_.kld.max_particles;
  if (start) {
    particles_ = draw_particles(PoseGaussian(start->T_map_base, start->covariance), count, rng_);
  } else {
    particles_ = {};
    for (int i = 0; i < count; ++i) particles_.poses.push_back(free_space_.sample(rng_));
    particles_.log_weights.assign(particles_.poses.size(), 0.0);
  }
  averages_.reset();
  updated_at_.reset();
  estimate_.reset();
}

void Amcl::on_odometry(const Odometry& odometry) {
  T_odom_base_.add(odometry.stamp, odometry.T_odom_base);
}

void Amcl::on_scan(const LaserScan& scan) {
  const bool late = last_scan_ && scan.stamp <= *last_scan_;
  const std::optional<SE2> T_odom_base = T_odom_base_.at(scan.stamp);
  if (late || !T_odom_base) {
    ++dropped_scans_;
    return;
  }
  last_scan_ = scan.stamp;
  if (!updated_at_ || moved_enough(*T_odom_base)) {
    const LaserScan thin = thinned(scan, config_.max_beams);
    const BeamSelection all{static_cast<int>(thin.ranges.size()) + 1, config_.max_range};
    const auto points = project_scan(thin, T_odom_base_, scan.stamp, all);
    if (points && !points->empty()) update(scan, *points, *T_odom_base);
  }
  if (updated_at_) publish(scan.stamp, *T_odom_base);
}

bool Amcl::moved_enough(const SE2& T_odom_base) const {
  return std::abs(T_odom_base.x - updated_at_->x) > config_.update_min_d ||
         std::abs(T_odom_base.y - updated_at_->y) > config_.update_min_d ||
         yaw_distance(T_odom_base, *updated_at_) > config_.update_min_a;
}

void Amcl::update(const LaserScan& scan, const ScanPoints& points, const SE2& T_odom_base) {
  if (updated_at_) {
    const DifferentialMotion motion(updated_at_->inverse() * T_odom_base, config_.motion);
    timer_.measure("predict", [&] {
      for (SE2& pose : particles_.poses) pose = motion.sample(pose, rng_);
    });
  }
  updated_at_ = T_odom_base;
  timer_.measure("correct", [&] { weigh(points, std::min(scan.range_max, config_.max_range)); });
  timer_.measure("resample", [&] { resample(); });
  timer_.measure("manage", [&] {
    output_ = heaviest_cluster(config_.kld, particles_);
    covariance_ = moments(particles_).covariance;
    quality_ = field_.quality(points, output_.mean);
    T_map_odom_ = output_.mean * T_odom_base.inverse();
  });
}

std::vector<double> Amcl::log_weights(const ScanPoints& points, double range_max) const {
  if (config_.model == AmclSensorModel::kLikelihoodFieldProb) {
    return prob_log_weights(field_, points, particles_.poses, range_max, config_.beam_skip);
  }
  std::vector<double> result;
  for (const SE2& pose : particles_.poses) {
    result.push_back(std::log(field_.weight(points, pose, range_max)));
  }
  return result;
}

void Amcl::weigh(const ScanPoints& points, double range_max) {
  const std::vector<double> before = normalized_weights(particles_);
  const std::vector<double> log_weights = this->log_weights(points, range_max);
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    total += before[i] * std::exp(log_weights[i]);
    particles_.log_weights[i] += log_weights[i];
  }
  averages_.add(total / static_cast<double>(particles_.size()));
}

/// KLD-sampling: draws until there are enough particles for the bins they cover.
void Amcl::resample() {
  std::vector<double> cumulated = normalized_weights(particles_);
  for (std::size_t i = 1; i < cumulated.size(); ++i) cumulated[i] += cumulated[i - 1];
  const double random_share = averages_.random_share();
  if (random_share > 0.0) averages_.reset();
  boost::random::uniform_real_distribution<double> unit(0.0, 1.0);
  ParticleSet next;
  std::set<PoseBin> bins;
  while (static_cast<int>(next.size()) < config_.kld.max_particles) {
    if (unit(rng_) < random_share) {
      next.poses.push_back(free_space_.sample(rng_));
    } else {
      const auto drawn = std::upper_bound(cumulated.begin(), cumulated.end() - 1, unit(rng_));
      next.poses.push_back(particles_.poses[static_cast<std::size_t>(drawn - cumulated.begin())]);
    }
    next.log_weights.push_back(0.0);
    bins.insert(bin_of(config_.kld, next.poses.back()));
    if (static_cast<int>(next.size()) > kld_limit(config_.kld, bins.size())) break;
  }
  particles_ = std::move(next);
}

void Amcl::publish(Stamp stamp, const SE2& T_odom_base) {
  Estimate estimate;
  estimate.stamp = stamp;
  estimate.T_map_base = T_map_odom_ * T_odom_base;
  estimate.covariance = covariance_;
  estimate.quality = quality_;
  estimate.probability = output_.weight;
  estimate_ = estimate;
}

Diagnostics Amcl::diagnostics() const {
  Diagnostics diagnostics;
  const SE2 mean = estimate_ ? estimate_->T_map_base : SE2{};
  diagnostics.populations.push_back({0, mean, quality_, output_.weight, true, particles_.poses});
  diagnostics.dropped_scans = dropped_scans_;
  diagnostics.cpu_by_stage = timer_.totals();
  return diagnostics;
}

}  // namespace castaway::localization
