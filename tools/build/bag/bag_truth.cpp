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

double height_of(const TruePose& pose) { return pose.T_footprint_base.translation().z(); }

bool is_jump(const TruePose& before, const TruePose& after) {
  return localization::distance(before.T_map_base, after.T_map_base) > kTruthJump ||
         std::abs(height_of(after) - height_of(before)) > kTruthJump;
}

TruePose interpolate(const TruePose& a, const TruePose& b, double fraction) {
  TruePose between{localization::interpolate(a.T_map_base, b.T_map_base, fraction)};
  const Eigen::Quaterniond turn(a.T_footprint_base.linear());
  between.T_footprint_base.linear() =
      turn.slerp(fraction, Eigen::Quaterniond(b.T_footprint_base.linear())).toRotationMatrix();
  between.T_footprint_base.translation().z() =
      (1.0 - fraction) * height_of(a) + fraction * height_of(b);
  return between;
}

}  // namespace

TruePose true_pose_of(const ros::Pose& pose) {
  TruePose made{from_ros_pose(pose)};
  const ros::Quaternion& q = pose.orientation;
  const ros::Point& p = pose.position;
  if (p.z == 0.0 && q.x == 0.0 && q.y == 0.0) return made;  // Planar: exactly the identity.
  const Eigen::Isometry3d T_map_base = from_ros_transform({{p.x, p.y, p.z}, q});
  made.T_footprint_base = localization::to_se3(made.T_map_base).inverse() * T_map_base;
  made.T_footprint_base.translation() = Eigen::Vector3d(0.0, 0.0, p.z);
  return made;
}

void BagTruth::lower(double height) {
  if (!has_heights()) return;
  for (auto* poses : {&poses_, &of_scans_}) {
    for (auto& [stamp, pose] : *poses) pose.T_footprint_base.translation().z() -= height;
  }
}

bool BagTruth::has_heights() const {
  const auto has_height = [](const auto& entry) { return height_of(entry.second) != 0.0; };
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
