#include "localization/paper/correct_by_rays.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::localization {

std::vector<RayLocalScore> ray_scores(const RayLocalModel& model, const ScanPoints& points,
                                      const ParticleSet& particles) {
  std::vector<RayLocalScore> scores;
  scores.reserve(particles.size());
  for (const SE2& pose : particles.poses) scores.push_back(model.evaluate(points, pose));
  return scores;
}

void multiply_weights(const std::vector<RayLocalScore>& scores, ParticleSet& particles) {
  for (std::size_t i = 0; i < scores.size(); ++i) {
    particles.log_weights[i] += scores[i].log_likelihood;
  }
}

double mean_quality(const std::vector<RayLocalScore>& scores, double beams) {
  double sum = 0.0;
  for (const RayLocalScore& score : scores) sum += score.hits;
  return sum / (beams * static_cast<double>(scores.size()));
}

void set_quality(double quality, Hypothesis& hypothesis) {
  hypothesis.quality = quality;
  hypothesis.log_weight = std::log(std::max(quality, 1e-9));
}

void correct_by_rays(const RayLocalModel& model, const ScanPoints& points, Hypothesis& hypothesis) {
  if (points.empty()) return;
  const std::vector<RayLocalScore> scores = ray_scores(model, points, hypothesis.particles);
  multiply_weights(scores, hypothesis.particles);
  set_quality(mean_quality(scores, static_cast<double>(points.size())), hypothesis);
  hypothesis.belief = moments(hypothesis.particles);
}

}  // namespace castaway::localization
