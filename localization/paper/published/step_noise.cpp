#include "localization/paper/published/step_noise.hpp"

#include <boost/random/normal_distribution.hpp>

namespace castaway::localization {

SE2 StepNoiseMotion::sample(const SE2& T_map_base0, Rng& rng) const {
  boost::random::normal_distribution<double> normal;
  const double trans = config_.trans * normal(rng);
  const double rot = config_.rot * normal(rng);
  return T_map_base0 * u_ * SE2{u_.x * trans, u_.y * trans, u_.yaw * rot};
}

}  // namespace castaway::localization
