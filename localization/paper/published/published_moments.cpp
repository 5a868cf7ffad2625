#include "localization/paper/published/published_moments.hpp"

namespace castaway::localization {

PoseMoments published_moments(const ParticleSet& particles, const PublishedDefects& defects) {
  PoseMoments result = moments(particles);
  if (!defects.unweighted_covariance && !defects.unwrapped_yaw) return result;
  std::vector<double> weights = normalized_weights(particles);
  SE2 mean = result.mean;
  if (defects.unweighted_covariance) {
    const auto n = static_cast<double>(weights.size());
    weights.assign(weights.size(), 1.0 / (n - 1.0));
    mean = pose_moments(particles.poses, weights).mean;
  }
  result.covariance.setZero();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const SE2& p = particles.poses[i];
    const double turn = p.yaw - mean.yaw;
    const Eigen::Vector3d d(p.x - mean.x, p.y - mean.y,
                            defects.unwrapped_yaw ? turn : wrap_angle(turn));
    result.covariance += weights[i] * d * d.transpose();
  }
  return result;
}

}  // namespace castaway::localization
