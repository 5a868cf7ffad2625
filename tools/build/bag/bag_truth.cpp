#include "tools/build/bag/bag_truth.hpp"

#include <algorithm>
#include <iterator>

#include "localization/geometry/se2.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr Stamp kTruthGap = std::chrono::milliseconds(500);  // Longest gap over which truth is
                                                             // interpolated.
constexpr double kTruthJump = 0.5;                           // [m] A longer step is a kidnap and is
                                                             // not interpolated.

bool is_jump(const TruePose& before, const TruePose& after) {
  return localization::distance(before.T_map_base, after.T_map_base) > kTruthJump ||
         std::abs(after.z() - before.z()) > kTruthJump;
}

TruePose interpolate(const TruePose& a, const TruePose& b, double fraction) {
  TruePose between(localization::interpolate(a.T_map_base, b.T_map_base, fraction));
  if (!a.T_footprint_base || !b.T_footprint_base) return between;
  const Eigen::Quaterniond turn(a.T_footprint_base->linear());
  Eigen::Isometry3d& above = between.T_footprint_base.emplace(Eigen::Isometry3d::Identity());
  above.linear() =
      turn.slerp(fraction, Eigen::Quaterniond(b.T_footprint_base->linear())).toRotationMatrix();
  above.translation().z() = (1.0 - fraction) * a.z() + fraction * b.z();
  return between;
}

}  // namespace

TruePose true_pose_of(const ros::Pose& pose) {
  TruePose made(from_ros_pose(pose));
  Eigen::Isometry3d& above = made.T_footprint_base.emplace(Eigen::Isometry3d::Identity());
  const ros::Quaternion& q = pose.orientation;
  const ros::Point& p = pose.position;
  if (p.z == 0.0 && q.x == 0.0 && q.y == 0.0) return made;  // Planar: exactly the identity.
  const Eigen::Isometry3d T_map_base = from_ros_transform({{p.x, p.y, p.z}, q});
  above = localization::to_se3(made.T_map_base).inverse() * T_map_base;
  above.translation() = Eigen::Vector3d(0.0, 0.0, p.z);
  return made;
}

void BagTruth::lower(double height) {
  if (!has_heights()) return;
  for (auto* poses : {&poses_, &of_scans_}) {
    for (auto& [stamp, pose] : *poses) {
      if (pose.T_footprint_base) pose.T_footprint_base->translation().z() -= height;
    }
  }
}

void BagTruth::drop_level_ground() {
  if (has_heights()) return;
  for (auto* poses : {&poses_, &of_scans_}) {
    for (auto& [stamp, pose] : *poses) pose.T_footprint_base.reset();
  }
}

bool BagTruth::has_heights() const {
  const auto has_height = [](const auto& entry) { return entry.second.z() != 0.0; };
  return std::ranges::any_of(poses_, has_height) || std::ranges::any_of(of_scans_, has_height);
}

std::optional<TruePose> BagTruth::at(Stamp stamp) const {
  const auto after = poses_.lower_bound(stamp);
  if (after == poses_.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == poses_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const Stamp gap = after->first - before->first;
  if (gap > kTruthGap || is_jump(before->second, after->second)) return std::nullopt;
  const double fraction = seconds(stamp - before->first) / seconds(gap);
  return interpolate(before->second, after->second, fraction);
}

std::optional<TruePose> BagTruth::of_scan(Stamp stamp) const {
  const auto exact = of_scans_.find(stamp);
  return exact != of_scans_.end() ? std::optional(exact->second) : at(stamp);
}

}  // namespace castaway::testbed
