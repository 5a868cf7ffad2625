#include "localization/hypotheses/correct_by_rays.hpp"

#include <algorithm>
#include <cmath>

#include "localization/filter/published_moments.hpp"

namespace castaway::localization {
namespace {

void multiply(const std::vector<RayLocalScore>& scores, ParticleSet& particles) {
  for (std::size_t i = 0; i < scores.size(); ++i) {
    particles.log_weights[i] += scores[i].log_likelihood;
  }
}

/// Adds the hits to normalised weights, at least 1e-6.
void add(const std::vector<RayLocalScore>& scores, ParticleSet& particles) {
  const std::vector<double> before = normalized_weights(particles);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    particles.log_weights[i] = std::log(std::max(before[i] + scores[i].hits, 1e-6));
  }
}

double quality_of(const std::vector<RayLocalScore>& scores, const ScanPoints& points,
                  const PublishedDefects& defects) {
  double beams = static_cast<double>(points.size());
  if (defects.invalid_beams_counted) beams /= points.valid_share;
  double sum = 0.0;
  double best = 0.0;
  for (const RayLocalScore& score : scores) {
    sum += score.hits;
    best = std::max(best, score.hits);
  }
  if (defects.best_particle_quality) return best / beams;
  return sum / (beams * static_cast<double>(scores.size()));
}

}  // namespace

void correct_by_rays(Hypothesis& hypothesis, const RayLocalModel& model, const ScanPoints& points,
                     const PublishedDefects& defects) {
  if (points.empty()) return;
  ParticleSet& particles = hypothesis.particles;
  std::vector<RayLocalScore> scores;
  scores.reserve(particles.size());
  for (const SE2& pose : particles.poses) scores.push_back(model.evaluate(points, pose));
  if (defects.summed_weights) {
    add(scores, particles);
  } else {
    multiply(scores, particles);
  }
  hypothesis.quality = quality_of(scores, points, defects);
  hypothesis.log_weight = std::log(std::max(hypothesis.quality, 1e-9));
  hypothesis.belief = published_moments(particles, defects);
}

}  // namespace castaway::localization
