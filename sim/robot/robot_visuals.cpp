#include "sim/robot/robot_visuals.hpp"

#include <algorithm>
#include <string>

#include "sim/scene/primitives.hpp"
#include "sim/world/world_visuals.hpp"
#include "xacro/files/lower_case.hpp"

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

const Eigen::Vector3f kGrey(0.6F, 0.6F, 0.6F);

/// STL files carry no materials.
bool has_own_colors(const RobotShape& shape) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  if (mesh == nullptr) return false;
  return to_lower(mesh->path.substr(mesh->path.find_last_of('.') + 1)) != "stl";
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

std::vector<SceneItem> robot_visuals(const RobotModel& robot) {
  std::vector<SceneItem> items;
  for (const RobotPart& part : robot.visuals) {
    SceneItem item;
    item.mesh = std::visit([](const auto& shape) { return shape_mesh(shape); }, part.shape);
    item.T_map_mesh = part.T_base_part.cast<float>();
    if (!has_own_colors(part.shape)) {
      item.mesh.colors.clear();
      item.color = part.color.value_or(kGrey);
    }
    items.push_back(std::move(item));
  }
  return items;
}

}  // namespace castaway::sim
