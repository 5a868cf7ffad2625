#include "localization/amcl.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "localization/filter/kld_resample.hpp"

namespace castaway::localization {
namespace {

/// The map, shifted by half a cell if configured.
OccupancyGrid place_map(const AmclConfig& config, OccupancyGrid map) {
  validate(map);
  const double shift = config.half_cell_shift ? -0.5 * map.frame.resolution : 0.0;
  map.frame.T_map_grid = map.frame.T_map_grid * SE2{shift, shift, 0.0};
  return map;
}

Eigen::Matrix3d spread_of(const AmclConfig& config, const PoseWithCovariance& start) {
  if (!start.covariance.isZero(0.0)) return start.covariance;
  const InitialSpread& s = config.initial;
  return Eigen::Vector3d(s.sigma_m * s.sigma_m, s.sigma_m * s.sigma_m, s.sigma_yaw * s.sigma_yaw)
      .asDiagonal();
}

}  // namespace

Amcl::Amcl(const AmclConfig& config, const OccupancyGrid& map, std::uint64_t seed, StageClock clock)
    : config_((validate(config), config)),
      map_(place_map(config, map)),
      field_(config.sensor, map_),
      free_space_(map_),
      rng_(substream(seed, "amcl")),
      timer_(std::move(clock)),
      intake_(config.intake),
      averages_(config.recovery) {
  if (free_space_.empty()) throw std::invalid_argument("map has no free cell to start on");
  if (config_.model == AmclSensorModel::kBeam) beam_model_.emplace(config_.beam, map_);
  initialize(std::nullopt);
}

void Amcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  const int count = config_.kld.max_particles;
  if (start) {
    particles_ =
        draw_particles(PoseGaussian(start->T_map_base, spread_of(config_, *start)), count, rng_);
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
  if (intake_.take(odometry) != OdometryIntake::kRestarted) return;
  updated_at_.reset();
  estimate_.reset();
}

void Amcl::on_scan(const LaserScan& scan) {
  if (!intake_.accept(scan)) return;
  const SE2 T_odom_base = *intake_.T_odom_base().at(scan.stamp);
  if (is_awaited(scan.lidar, T_odom_base)) {
    const auto beams =
        take_beams(scan, intake_.T_odom_base(), config_.max_beams, config_.max_range);
    const double range_max = std::min(scan.range_max, config_.max_range);
    if (beams && is_informative(*beams)) update(*beams, range_max, T_odom_base);
  }
  if (updated_at_) publish(scan.stamp, T_odom_base);
}

bool Amcl::is_informative(const BeamScan& beams) const {
  return !beams.returns.empty() || (beam_model_ && !beams.misses.empty());
}

/// After enough motion the next scan of every lidar causes an update, as in Nav2.
bool Amcl::is_awaited(const std::string& lidar, const SE2& T_odom_base) {
  awaited_.try_emplace(lidar, true);
  if (!updated_at_ || config_.update_at_rest || moved_enough(T_odom_base)) {
    for (auto& [name, awaited] : awaited_) awaited = true;
  }
  return std::exchange(awaited_[lidar], false);
}

bool Amcl::moved_enough(const SE2& T_odom_base) const {
  return std::abs(T_odom_base.x - updated_at_->x) > config_.update_min_d ||
         std::abs(T_odom_base.y - updated_at_->y) > config_.update_min_d ||
         yaw_distance(T_odom_base, *updated_at_) > config_.update_min_a;
}

void Amcl::update(const BeamScan& beams, double range_max, const SE2& T_odom_base) {
  if (updated_at_) {
    const DifferentialMotion motion(updated_at_->inverse() * T_odom_base, config_.motion);
    timer_.measure("predict", [&] {
      for (SE2& pose : particles_.poses) pose = motion.sample(pose, rng_);
    });
  }
  updated_at_ = T_odom_base;
  timer_.measure("correct", [&] { weigh(beams, range_max); });
  timer_.measure("resample", [&] { resample(); });
  timer_.measure("manage", [&] {
    output_ = heaviest_cluster(config_.kld, particles_);
    covariance_ = moments(particles_).covariance;
    quality_ = field_.quality(beams.returns, output_.mean);
    T_map_odom_ = output_.mean * T_odom_base.inverse();
  });
}

std::vector<double> Amcl::log_weights(const BeamScan& beams, double range_max) const {
  if (config_.model == AmclSensorModel::kLikelihoodFieldProb) {
    return prob_log_weights(field_, beams.returns, particles_.poses, range_max, config_.beam_skip);
  }
  std::vector<double> result;
  for (const SE2& pose : particles_.poses) {
    const double weight = beam_model_ ? beam_model_->weight(beams, pose, range_max)
                                      : field_.weight(beams.returns, pose, range_max);
    result.push_back(std::log(weight));
  }
  return result;
}

void Amcl::weigh(const BeamScan& beams, double range_max) {
  const std::vector<double> before = normalized_weights(particles_);
  const std::vector<double> log_weights = this->log_weights(beams, range_max);
  double total = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    total += before[i] * std::exp(log_weights[i]);
    particles_.log_weights[i] += log_weights[i];
  }
  averages_.add(total / static_cast<double>(particles_.size()));
}

void Amcl::resample() {
  const double random_share = averages_.random_share();
  if (random_share > 0.0) averages_.reset();
  particles_ = kld_resample(particles_, config_.kld, free_space_, random_share, rng_);
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
  diagnostics.dropped_scans = intake_.dropped_scans();
  diagnostics.dropped_odometry = intake_.dropped_odometry();
  diagnostics.cpu_by_stage = timer_.totals();
  return diagnostics;
}

}  // namespace castaway::localization
