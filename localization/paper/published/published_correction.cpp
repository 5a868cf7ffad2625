#include "localization/paper/published/published_correction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "localization/paper/correct_by_rays.hpp"
#include "localization/paper/published/published_moments.hpp"

namespace castaway::localization {
namespace {

/// Adds the hits to the normalised weights; at least 1e-6.
void add_weights(const std::vector<RayLocalScore>& scores, ParticleSet& particles) {
  const std::vector<double> before = normalized_weights(particles);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    particles.log_weights[i] = std::log(std::max(before[i] + scores[i].hits, 1e-6));
  }
}

double published_quality(const std::vector<RayLocalScore>& scores, const ScanPoints& points,
                         const PublishedDefects& defects) {
  double beams = static_cast<double>(points.size());
  if (defects.invalid_beams_counted) beams /= points.valid_share;
  if (!defects.best_particle_quality) return mean_quality(scores, beams);
  double best = 0.0;
  for (const RayLocalScore& score : scores) best = std::max(best, score.hits);
  return best / beams;
}

}  // namespace

RayLocalConfig published_sensor(RayLocalConfig config, const PublishedDefects& defects) {
  if (!defects.summed_weights) return config;
  config.hit_peak = 1.0 / (config.sigma * std::sqrt(2.0 * std::numbers::pi));
  return config;
}

void published_correct(const RayLocalModel& model, const ScanPoints& points,
                       const PublishedDefects& defects, Hypothesis& hypothesis) {
  if (points.empty()) return;
  const std::vector<RayLocalScore> scores = ray_scores(model, points, hypothesis.particles);
  if (defects.summed_weights) {
    add_weights(scores, hypothesis.particles);
  } else {
    multiply_weights(scores, hypothesis.particles);
  }
  set_quality(published_quality(scores, points, defects), hypothesis);
  hypothesis.belief = published_moments(hypothesis.particles, defects);
}

ParticleSet published_reseed(LoserReseedConfig config, const ParticleSet& particles,
                             const PublishedDefects& defects, Rng& rng) {
  if (defects.jitter_squared) {
    config.spread_m *= config.spread_m;
    config.spread_rad *= config.spread_rad;
  }
  const auto source = [&](std::size_t loser, std::size_t winner) {
    return defects.winner_unused ? loser % particles.size() : winner;
  };
  const LoserReseedRule rule{published_moments(particles, defects).covariance, source};
  return reseed_losers(config, particles, rule, rng);
}

}  // namespace castaway::localization
