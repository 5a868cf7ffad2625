#include "localization/hypotheses/spawn.hpp"

#include <string>

namespace castaway::localization {

Hypothesis Spawner::spawn(const PoseMoments& belief, double log_weight, const Evidence& evidence) {
  const double s = config_.sigma;
  const double r = config_.sigma_yaw;
  const Eigen::Matrix3d least = Eigen::Vector3d(s * s, s * s, r * r).asDiagonal();
  Hypothesis hypothesis;
  hypothesis.id = next_id_++;
  hypothesis.rng = substream(seed_, "population/" + std::to_string(hypothesis.id));
  hypothesis.belief = {belief.mean, belief.covariance + least};
  if (mixture_) {
    hypothesis.mixture = make_mixture(*mixture_, hypothesis.belief);
  } else {
    hypothesis.particles =
        draw_particles(PoseGaussian(belief.mean, hypothesis.belief.covariance),
                       particle_count(size_, hypothesis.belief.covariance), hypothesis.rng);
  }
  hypothesis.log_weight = log_weight;
  hypothesis.log_likelihood = evidence.log_likelihood;
  hypothesis.quality = evidence.quality;
  return hypothesis;
}

}  // namespace castaway::localization
