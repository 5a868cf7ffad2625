#include "localization/space/map3d/terrain_pose.hpp"

#include <array>
#include <cmath>
#include <span>

namespace castaway::localization {
namespace {

constexpr double kSteepest = 1.7;  // tan(60 deg)

}  // namespace

std::optional<TerrainPose> stand(const ElevationMap& map, const PlaneTransform& T_grid_map,
                                 const SE2& T_map_base, double z, const WheelStance& wheels) {
  const PlaneTransform T_map_contacts(T_map_base);
  const Eigen::Vector2d p_base = T_map_base.translation();
  const GroundPoint under = ground_at(map, T_grid_map * p_base, z);
  if (under.surface == nullptr) return std::nullopt;
  const double z_base = under.z;
  const std::vector<Eigen::Vector2d>& contacts = wheels.contacts();
  std::array<double, WheelStance::kMost> heights{};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    heights[i] = ground_at(map, T_grid_map * (T_map_contacts * contacts[i]), z_base).z - z_base;
    if (!(std::abs(heights[i]) <= kSteepest * contacts[i].norm())) return std::nullopt;
  }
  const StandingPlane plane = wheels.rest(std::span(heights).first(contacts.size()));
  const Eigen::Vector3d along(1.0, 0.0, plane.along);
  const Eigen::Vector3d across(0.0, 1.0, plane.across);
  Eigen::Matrix3d R_yaw_base;  // Columns: axes of base in the frame that is turned by yaw only.
  R_yaw_base.col(0) = along.normalized();
  R_yaw_base.col(2) = along.cross(across).normalized();
  R_yaw_base.col(1) = R_yaw_base.col(2).cross(R_yaw_base.col(0));
  TerrainPose pose;
  pose.level = under.surface->level;
  pose.T_map_base = Eigen::Translation3d(p_base.x(), p_base.y(), z_base + plane.z) *
                    Eigen::AngleAxisd(T_map_base.yaw, Eigen::Vector3d::UnitZ()) *
                    Eigen::Quaterniond(R_yaw_base);
  return pose;
}

}  // namespace castaway::localization
