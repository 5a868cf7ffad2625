#include "localization/motion/differential_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/random/normal_distribution.hpp>

namespace castaway::localization {
namespace {

// [m] For a shorter step the direction of motion is undefined.
constexpr double kTurnInPlace = 0.01;

/// Size of a turn for its noise: driving backwards does not count as half a turn.
double noise_angle(double rot) {
  return std::min(std::abs(wrap_angle(rot)), std::abs(wrap_angle(rot - std::numbers::pi)));
}

}  // namespace

DifferentialMotion::DifferentialMotion(const SE2& u, const DifferentialMotionConfig& config) {
  parts_.trans = std::hypot(u.x, u.y);
  parts_.rot1 = parts_.trans < kTurnInPlace ? 0.0 : std::atan2(u.y, u.x);
  parts_.rot2 = wrap_angle(u.yaw - parts_.rot1);
  const double n1 = noise_angle(parts_.rot1);
  const double n2 = noise_angle(parts_.rot2);
  const double d2 = parts_.trans * parts_.trans;
  parts_.sigma_rot1 = std::sqrt(config.alpha1 * n1 * n1 + config.alpha2 * d2);
  parts_.sigma_trans = std::sqrt(config.alpha3 * d2 + config.alpha4 * (n1 * n1 + n2 * n2));
  parts_.sigma_rot2 = std::sqrt(config.alpha1 * n2 * n2 + config.alpha2 * d2);
}

SE2 DifferentialMotion::sample(const SE2& T_map_base0, Rng& rng) const {
  boost::random::normal_distribution<double> normal;
  const double rot1 = parts_.rot1 - parts_.sigma_rot1 * normal(rng);
  const double trans = parts_.trans - parts_.sigma_trans * normal(rng);
  const double rot2 = parts_.rot2 - parts_.sigma_rot2 * normal(rng);
  const double heading = T_map_base0.yaw + rot1;
  return {T_map_base0.x + trans * std::cos(heading), T_map_base0.y + trans * std::sin(heading),
          wrap_angle(heading + rot2)};
}

}  // namespace castaway::localization
