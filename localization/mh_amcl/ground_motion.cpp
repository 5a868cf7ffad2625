#include "localization/mh_amcl/ground_motion.hpp"

#include <cmath>

#include "localization/filter/predict.hpp"

namespace castaway::localization {
namespace {

void move(const Eigen::Vector2d& shift, SE2& pose) {
  pose.x += shift.x();
  pose.y += shift.y();
}

void settle_in_own_chart(const Atlas& atlas, Hypothesis& hypothesis) {
  const Eigen::Vector2d shift = atlas.to_own_chart(hypothesis.belief.mean);
  if (shift.isZero(0.0)) return;
  for (SE2& pose : hypothesis.particles.poses) move(shift, pose);
  for (GaussianComponent& c : hypothesis.mixture.components) move(shift, c.pose.mean);
  move(shift, hypothesis.belief.mean);
}

}  // namespace

SE2 along_ground(const Volume& volume, const SE2& T_atlas_base, const SE2& u) {
  const auto there = volume.atlas().to_map(T_atlas_base);
  if (!there) return u;
  const double yaw_grid = T_atlas_base.yaw - volume.atlas().frame().T_map_grid.yaw;
  const double rise = static_cast<double>(there->surface->slope_x) * std::cos(yaw_grid) +
                      static_cast<double>(there->surface->slope_y) * std::sin(yaw_grid);
  const double part = 1.0 / std::hypot(1.0, rise);
  return {part * u.x, u.y, u.yaw};
}

void predict_on_ground(const Volume& volume, const SE2& u, const OdometryNoiseConfig& noise,
                       std::vector<Hypothesis>& hypotheses) {
  for (Hypothesis& hypothesis : hypotheses) {
    const SE2 step = along_ground(volume, hypothesis.belief.mean, u);
    const OdometryMotion motion(step, noise);
    predict(hypothesis.particles, motion, hypothesis.rng);
    predict(hypothesis.mixture, step, motion.covariance());
    hypothesis.belief.mean = hypothesis.belief.mean * step;
    settle_in_own_chart(volume.atlas(), hypothesis);
  }
}

}  // namespace castaway::localization
