#include "tools/build/bag/bag_imu.hpp"

#include <map>
#include <optional>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

Eigen::Vector3d vector_of(const ros::Vector3& v) { return {v.x, v.y, v.z}; }

bool is_complete(const ros::Imu& imu) {
  return imu.angular_velocity_covariance.front() != -1.0 &&
         imu.linear_acceleration_covariance.front() != -1.0 &&
         vector_of(imu.angular_velocity).allFinite() &&
         vector_of(imu.linear_acceleration).allFinite();
}

}  // namespace

void BagImu::take(const ros::Imu& imu, Stamp stamp, Stamp logged, Frames& frames) {
  if (!is_complete(imu)) {
    ++incomplete_;
    return;
  }
  readings_.emplace_back(frames.size(), imu.header.frame_id);
  frames.push_back({logged, ImuFrame{{stamp, vector_of(imu.angular_velocity),
                                      vector_of(imu.linear_acceleration)}}});
}

std::vector<std::string> BagImu::turn_into_base(const BagMounts& mounts, Frames& frames) const {
  std::map<std::string, std::optional<Eigen::Isometry3d>> known;
  for (const auto& [index, frame] : readings_) {
    const auto [T_base_imu, first] = known.try_emplace(frame);
    if (first) T_base_imu->second = mounts.of(frame);
    if (!T_base_imu->second) continue;
    localization::Imu& imu = std::get<ImuFrame>(frames[index].data).imu;
    const Eigen::Matrix3d R_base_imu = T_base_imu->second->linear();
    imu.angular_velocity = R_base_imu * imu.angular_velocity;
    imu.linear_acceleration = R_base_imu * imu.linear_acceleration;
  }
  std::vector<std::string> warnings;
  for (const auto& [frame, T_base_imu] : known) {
    if (T_base_imu) continue;
    warnings.push_back(fmt::format(
        "no transform from '{}' to '{}'; the axes of the IMU are assumed to be those of "
        "base. Record /tf_static to provide them, or leave the IMU out by --imu-topic "
        "none",
        mounts.base_frame(), frame));
  }
  if (incomplete_ > 0) {
    warnings.push_back(fmt::format(
        "{} readings of the IMU lack turn rates or accelerations, and are not used", incomplete_));
  }
  return warnings;
}

}  // namespace castaway::testbed
