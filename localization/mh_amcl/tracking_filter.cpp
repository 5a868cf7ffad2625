#include "localization/mh_amcl/tracking_filter.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "localization/filter/correct.hpp"

namespace castaway::localization {
namespace {

void correct(GaussianComponent& component, const PoseClimber& climber, const RefineConfig& refine,
             const ScanPoints& points) {
  const PosePrior prior = make_prior(component.pose);
  const PoseClimber::Summit top = climber.summit(points, prior.mean, prior, refine);
  const Eigen::Matrix3d information = top.information + prior.information;
  component.log_weight +=
      top.log_likelihood + log_prior(prior, top.T_map_base) +
      0.5 * std::log(prior.information.determinant() / information.determinant());
  component.pose = {top.T_map_base, information.inverse()};
}

}  // namespace

void correct(GaussianMixture& mixture, const MixtureConfig& config, const PoseClimber& climber,
             const RefineConfig& refine, const ScanPoints& points) {
  for (GaussianComponent& component : mixture.components) {
    correct(component, climber, refine, points);
  }
  reduce(mixture, config);
}

void TrackingFilter::correct(Hypothesis& hypothesis, const ScanPoints& points) const {
  if (hypothesis.mixture.empty()) return correct_particles(hypothesis, points);
  localization::correct(hypothesis.mixture, mixture_, climber(), refine_, points);
  hypothesis.belief = moments(hypothesis.mixture);
}

void TrackingFilter::correct_particles(Hypothesis& hypothesis, const ScanPoints& points) const {
  const PoseMoments predicted = moments(hypothesis.particles);
  if (along_beams_) {
    localization::correct(hypothesis.particles, *along_beams_, points);
  } else {
    localization::correct(hypothesis.particles, model_, points);
  }
  const std::vector<double> weights = normalized_weights(hypothesis.particles);
  const auto count = static_cast<double>(weights.size());
  if (effective_size(weights) < reseed_.effective_share * count) {
    const auto best = std::max_element(weights.begin(), weights.end()) - weights.begin();
    const SE2& T_map_best = hypothesis.particles.poses[static_cast<std::size_t>(best)];
    reseed(hypothesis, refine_winner(T_map_best, predicted, points));
  }
  hypothesis.belief = moments(hypothesis.particles);
}

/// Climbs from the best particle to the maximum of the scan and odometry likelihoods together, or
/// to their mean along a ridge.
PoseGaussian TrackingFilter::refine_winner(const SE2& T_map_best, const PoseMoments& predicted,
                                           const ScanPoints& points) const {
  const PosePrior prior = make_prior(predicted);
  const PoseClimber climber = this->climber();
  const PoseClimber::Summit summit = climber.summit(points, T_map_best, prior, refine_);
  PoseMoments winner{summit.T_map_base, (summit.information + prior.information).inverse()};
  if (reseed_.ridge_steps > 0) {
    const auto log_posterior = [&](const SE2& pose) {
      return climber.log_likelihood(points, pose) + log_prior(prior, pose);
    };
    winner = average_along_ridge(log_posterior, winner, reseed_.ridge_steps);
  }
  return {winner.mean, winner.covariance};
}

void TrackingFilter::reseed(Hypothesis& hypothesis) const {
  if (hypothesis.mixture.empty()) reseed(hypothesis, std::nullopt);
}

void TrackingFilter::reseed(Hypothesis& hypothesis,
                            const std::optional<PoseGaussian>& winner) const {
  const int count = particle_count(reseed_, hypothesis.belief.covariance);
  hypothesis.particles = localization::reseed(hypothesis.particles, count, winner, hypothesis.rng);
}

PoseMoments TrackingFilter::belief_at(const SE2& T_map_base, const ScanPoints& points) const {
  Eigen::Matrix3d information = climber().information(points, T_map_base);
  constexpr double kMost = 0.3;  // [m] or [rad] Standard deviation where the scan says nothing.
  information += Eigen::Vector3d::Constant(1.0 / (kMost * kMost)).asDiagonal();
  return {T_map_base, information.inverse()};
}

}  // namespace castaway::localization
