#include "sim/people/forces/social_force.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::sim {
namespace {

double decay(double x) { return x > kNegligible ? 0.0 : std::exp(-x); }

}  // namespace

Eigen::Vector2d driving_force(const SocialForceConfig& config, const Eigen::Vector2d& velocity,
                              const Eigen::Vector2d& desired_velocity) {
  return (desired_velocity - velocity) / config.relaxation;
}

Eigen::Vector2d social_force(const SocialForceConfig& config, const Eigen::Vector2d& offset,
                             const Eigen::Vector2d& approach) {
  const double d = offset.norm();
  if (d == 0.0 || d > config.reach) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d e = offset / d;
  const Eigen::Vector2d D = config.lambda * approach + e;
  const double length = D.norm();
  const double B = config.gamma * length;
  if (d > kNegligible * B) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d t = D / length;
  const double narrow = std::min(config.n, config.n_prime) * B;
  // 2 (1 - cos(theta)) is a lower bound of theta^2: where the force is negligible by it, no arc
  // tangent is computed.
  const double least = d / B + 2.0 * narrow * narrow * (1.0 - t.dot(e));
  if (least > kNegligible + 1e-9) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d left(-t.y(), t.x());
  const double theta = std::atan2(left.dot(e), t.dot(e));
  const double side = theta < 0.0 ? -1.0 : 1.0;
  const double slow = config.n_prime * B * theta;
  const double turn = config.n * B * theta;
  return -config.social *
         (decay(d / B + slow * slow) * t + side * decay(d / B + turn * turn) * left);
}

Eigen::Vector2d obstacle_force(const SocialForceConfig& config, double gap,
                               const Eigen::Vector2d& away) {
  if (gap > kNegligible * config.obstacle_range) return Eigen::Vector2d::Zero();
  return config.obstacle * std::exp(-gap / config.obstacle_range) * away;
}

}  // namespace castaway::sim
