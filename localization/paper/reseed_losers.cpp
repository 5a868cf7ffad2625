#include "localization/paper/reseed_losers.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <boost/random/normal_distribution.hpp>

namespace castaway::localization {
namespace {

/// Returns the poses by descending weight; the order of equal weights is kept.
std::vector<SE2> sort_by_weight(const ParticleSet& particles) {
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return particles.log_weights[a] > particles.log_weights[b];
  });
  std::vector<SE2> poses;
  poses.reserve(order.size());
  for (const std::size_t i : order) poses.push_back(particles.poses[i]);
  return poses;
}

std::size_t next_count(const LoserReseedConfig& config, const Eigen::Matrix3d& covariance,
                       std::size_t present) {
  const double spread = std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
  int count = static_cast<int>(present);
  if (spread > config.high_spread_m) count += config.step;
  if (spread < config.low_spread_m) count -= config.step;
  return static_cast<std::size_t>(std::clamp(count, config.min_particles, config.max_particles));
}

}  // namespace

void validate(const LoserReseedConfig& config) {
  if (!(config.losers >= 0.0 && config.losers < 1.0 && config.winners > 0.0 &&
        config.winners + config.losers <= 1.0)) {
    throw std::invalid_argument("reseed: need 0 <= losers, 0 < winners, losers + winners <= 1");
  }
  if (config.min_particles < 2 || config.max_particles < config.min_particles) {
    throw std::invalid_argument("particles: need 2 <= min_particles <= max_particles");
  }
}

ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles, Rng& rng) {
  const auto copy_winner = [](std::size_t, std::size_t winner) { return winner; };
  return reseed_losers(config, particles, {moments(particles).covariance, copy_winner}, rng);
}

ParticleSet reseed_losers(const LoserReseedConfig& config, const ParticleSet& particles,
                          const LoserReseedRule& rule, Rng& rng) {
  assert(particles.size() > 0);
  const std::vector<SE2> poses = sort_by_weight(particles);
  const auto size = static_cast<double>(poses.size());
  const std::size_t count = next_count(config, rule.covariance, poses.size());
  const auto kept = std::min(
      count,
      std::max<std::size_t>(1, poses.size() - static_cast<std::size_t>(config.losers * size)));
  const auto winners = std::max<std::size_t>(1, static_cast<std::size_t>(config.winners * size));
  ParticleSet next;
  next.poses.assign(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(kept));
  boost::random::normal_distribution<double> normal;
  for (std::size_t loser = 0; next.poses.size() < count; ++loser) {
    const double drawn = std::abs(normal(rng)) * static_cast<double>(winners) / 2.0;
    const std::size_t winner = std::min(static_cast<std::size_t>(drawn), winners - 1);
    const SE2& source = poses[rule.source(loser, winner)];
    const double dx = config.spread_m * normal(rng);
    const double dy = config.spread_m * normal(rng);
    const double dyaw = config.spread_rad * normal(rng);
    next.poses.push_back({source.x + dx, source.y + dy, wrap_angle(source.yaw + dyaw)});
  }
  next.log_weights.assign(count, 0.0);
  return next;
}

}  // namespace castaway::localization
