#include "localization/mh_amcl/ground_motion.hpp"

#include "localization/filter/predict.hpp"

namespace castaway::localization {
namespace {

void move(const Eigen::Vector2d& shift, SE2& pose) {
  pose.x += shift.x();
  pose.y += shift.y();
}

void settle_in_own_chart(const Ground& ground, Hypothesis& hypothesis) {
  const Eigen::Vector2d shift = to_own_chart(ground, hypothesis.belief.mean);
  if (shift.isZero(0.0)) return;
  for (SE2& pose : hypothesis.particles.poses) move(shift, pose);
  for (GaussianComponent& c : hypothesis.mixture.components) move(shift, c.pose.mean);
  move(shift, hypothesis.belief.mean);
}

}  // namespace

void predict_on_ground(const Ground& ground, const SE2& u, const OdometryNoiseConfig& noise,
                       std::vector<Hypothesis>& hypotheses) {
  for (Hypothesis& hypothesis : hypotheses) {
    const SE2 step = along_ground(ground, hypothesis.belief.mean, u);
    const OdometryMotion motion(step, noise);
    predict(hypothesis.particles, motion, hypothesis.rng);
    predict(hypothesis.mixture, step, motion.covariance());
    hypothesis.belief.mean = hypothesis.belief.mean * step;
    settle_in_own_chart(ground, hypothesis);
  }
}

}  // namespace castaway::localization
