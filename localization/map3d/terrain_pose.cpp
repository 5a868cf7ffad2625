#include "localization/map3d/terrain_pose.hpp"

#include <array>
#include <cmath>
#include <span>

namespace castaway::localization {
namespace {

constexpr double kSteepest = 1.7;  // tan(60 deg)

}  // namespace

std::optional<TerrainPose> stand(const ElevationMap& map, const SE2& T_map_base, double z,
                                 const WheelStance& wheels) {
  const Eigen::Vector2d p_base = T_map_base.translation();
  const GroundSurface* under = surface_near(map, p_base, z);
  if (under == nullptr) return std::nullopt;
  const double z_base = ground_height(map, p_base, z);
  const std::vector<Eigen::Vector2d>& contacts = wheels.contacts();
  std::array<double, WheelStance::kMost> heights{};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    heights[i] = ground_height(map, T_map_base * contacts[i], z_base) - z_base;
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
  pose.level = under->level;
  pose.T_map_base = Eigen::Translation3d(p_base.x(), p_base.y(), z_base + plane.z) *
                    Eigen::AngleAxisd(T_map_base.yaw, Eigen::Vector3d::UnitZ()) *
                    Eigen::Quaterniond(R_yaw_base);
  return pose;
}

}  // namespace castaway::localization
