/// The robot's pose in the frame in which it is planned for.
#pragma once

#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "sim/common/geometry.hpp"
#include "sim/map/level_plane.hpp"

namespace castaway::sim {

/// Follows the robot from floor to floor. Without floors, frame plane is map.
class PlaneTracker {
 public:
  explicit PlaneTracker(std::shared_ptr<const LevelPlane> plane) : plane_(std::move(plane)) {}

  /// T_plane_base; where there is no ground, in the chart of the last call.
  Pose2 locate(const Eigen::Isometry3d& T_map_base) {
    const Pose2 planar = to_planar(T_map_base);
    if (!plane_) return planar;
    const auto found = plane_->on_plane(planar, T_map_base.translation().z());
    if (found) shift_ = found->y - planar.y;
    return {planar.x, planar.y + shift_, planar.yaw};
  }

  /// T_map_base of a pose in the plane.
  [[nodiscard]] Pose2 in_map(const Pose2& T_plane_base) const {
    return plane_ ? plane_->in_map(T_plane_base) : T_plane_base;
  }
  /// [m] Height of the ground at a pose in the plane.
  [[nodiscard]] double height_at(const Pose2& T_plane_base) const {
    return plane_ ? plane_->p_map(T_plane_base.position()).z() : 0.0;
  }
  /// T_map_base of a base that stands at a pose in the plane.
  [[nodiscard]] Eigen::Isometry3d standing_at(const Pose2& T_plane_base) const {
    return plane_ ? plane_->standing_at(T_plane_base) : to_isometry(T_plane_base);
  }
  [[nodiscard]] const LevelPlane* levels() const { return plane_.get(); }

 private:
  std::shared_ptr<const LevelPlane> plane_;
  double shift_ = 0.0;  ///< [m] Along y from map to the chart.
};

}  // namespace castaway::sim
