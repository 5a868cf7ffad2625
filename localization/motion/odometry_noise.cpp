#include "localization/motion/odometry_noise.hpp"

#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include <boost/random/normal_distribution.hpp>

namespace castaway::localization {

void validate(const OdometryNoiseConfig& config) {
  for (const double value :
       {config.trans_per_m, config.trans_per_rad, config.rot_per_m, config.rot_per_rad}) {
    if (!(value >= 0.0)) throw std::invalid_argument("odometry noise must not be negative");
  }
}

OdometryMotion::OdometryMotion(const SE2& u, const OdometryNoiseConfig& config) : u_(u) {
  const double trans = std::hypot(u.x, u.y);
  const double rot = std::abs(u.yaw);
  sigma_trans_ = std::sqrt(config.trans_per_m * config.trans_per_m * trans +
                           config.trans_per_rad * config.trans_per_rad * rot);
  sigma_rot_ = std::sqrt(config.rot_per_m * config.rot_per_m * trans +
                         config.rot_per_rad * config.rot_per_rad * rot);
}

SE2 OdometryMotion::sample(const SE2& T_map_base0, Rng& rng) const {
  if (u_ == SE2{}) return T_map_base0;
  boost::random::normal_distribution<double> normal;
  const double dx = sigma_trans_ * normal(rng);
  const double dy = sigma_trans_ * normal(rng);
  const double dyaw = sigma_rot_ * normal(rng);
  return T_map_base0 * SE2{u_.x + dx, u_.y + dy, u_.yaw + dyaw};
}

Eigen::Matrix3d OdometryMotion::covariance() const {
  return Eigen::Vector3d(sigma_trans_ * sigma_trans_, sigma_trans_ * sigma_trans_,
                         sigma_rot_ * sigma_rot_)
      .asDiagonal();
}

Eigen::Matrix3d rotate_to_map(const Eigen::Matrix3d& covariance_base, double yaw) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return R * covariance_base * R.transpose();
}

}  // namespace castaway::localization
