#include "sim/robot/robot_visuals.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "sim/world/world_visuals.hpp"

namespace castaway::sim {
namespace {

const Eigen::Vector3f kGrey(0.6F, 0.6F, 0.6F);

/// STL files carry no materials.
bool has_own_colors(const RobotShape& shape) {
  const auto* mesh = std::get_if<MeshShape>(&shape);
  if (mesh == nullptr) return false;
  std::string extension = mesh->path.substr(mesh->path.find_last_of('.') + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension != "stl";
}

}  // namespace

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
