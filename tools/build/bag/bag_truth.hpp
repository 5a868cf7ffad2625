/// True poses of base in a bag, by time.
#pragma once

#include <map>
#include <optional>

#include "tools/ros/ros_geometry.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// With height, roll and pitch. Throws as `from_ros_pose` and `from_ros_transform`.
TruePose true_pose_of(const ros::Pose& pose);

/// Poses of one topic, interpolated over at most half a second and never across a kidnap. Another
/// topic may state the exact pose of each scan.
class BagTruth {
 public:
  void add(Stamp stamp, const TruePose& pose) { poses_[stamp] = pose; }
  void add_of_scan(Stamp stamp, const TruePose& pose) { of_scans_[stamp] = pose; }
  /// Lowers all poses with a height by this much [m]; planar truth stays at 0.
  void lower(double height);

  /// Takes heights, rolls and pitches away if all poses are at z = 0: those of a planar truth.
  void drop_level_ground();
  /// The true pose at a time; nothing if unknown.
  [[nodiscard]] std::optional<TruePose> at(Stamp stamp) const;
  /// The true pose of the scan with this stamp; nothing if unknown.
  [[nodiscard]] std::optional<TruePose> of_scan(Stamp stamp) const;

 private:
  [[nodiscard]] bool has_heights() const;

  std::map<Stamp, TruePose> poses_;
  std::map<Stamp, TruePose> of_scans_;
};

}  // namespace castaway::testbed
