#include "localization/mh_amcl/mixture_filter.hpp"

#include <cmath>

#include <Eigen/LU>

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

}  // namespace castaway::localization
