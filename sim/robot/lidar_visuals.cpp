#include "sim/robot/lidar_visuals.hpp"

#include <algorithm>

#include "sim/scene/primitives.hpp"

namespace castaway::sim {
namespace {

constexpr float kLidarRadius = 0.04F;  // [m]
constexpr float kHeight = 0.05F;       // [m]
constexpr float kMast = 0.012F;        // [m] Radius of the mast.
const Eigen::Vector3f kColor(0.13F, 0.14F, 0.16F);

SceneItem dark(TriangleMesh mesh, const Eigen::Isometry3f& T_base_mesh) {
  SceneItem item;
  item.mesh = std::move(mesh);
  item.T_map_mesh = T_base_mesh;
  item.color = kColor;
  return item;
}

}  // namespace

std::vector<SceneItem> lidar_visuals(const RobotModel& robot, const LidarConfig& lidar) {
  if (!robot.lidars.empty()) return {};
  const Eigen::Isometry3f T_base_laser = lidar.T_base_laser.cast<float>();
  std::vector<SceneItem> items{dark(cylinder_mesh(kLidarRadius, kHeight), T_base_laser)};
  const float top = T_base_laser.translation().z() - 0.5F * kHeight;
  // The mast starts within the body, whose highest part need not be below the lidar.
  const float foot = std::min(0.5F * static_cast<float>(robot.height), top);
  if (top - foot < 1e-3F) return items;
  Eigen::Isometry3f T_base_mast = Eigen::Isometry3f::Identity();
  T_base_mast.translation() = T_base_laser.translation();
  T_base_mast.translation().z() = 0.5F * (top + foot);
  items.push_back(dark(cylinder_mesh(kMast, top - foot), T_base_mast));
  return items;
}

}  // namespace castaway::sim
