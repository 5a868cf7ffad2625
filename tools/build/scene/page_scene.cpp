#include "tools/build/scene/page_scene.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/build/scene/merged_mesh.hpp"
#include "tools/build/scene/person_model.hpp"

namespace castaway::testbed {
namespace {

using SceneJson = nlohmann::ordered_json;

constexpr float kGhostCell = 0.02F;  // [m]
constexpr float kFirstCell = 0.01F;  // [m]
constexpr float kLastCell = 2.0F;    // [m] Nothing of use is left of coarser meshes.

/// The meshes of a scene.
struct SceneMeshes {
  MergedMesh world;
  MergedMesh roof;
  MergedMesh robot;
  float cell = 0.0F;  ///< [m]

  [[nodiscard]] std::size_t bytes() const {
    return json_size(world) + json_size(roof) + json_size(robot);
  }
};

SceneMeshes merge_scene(const PageScene& scene, float cell) {
  return {merge_items(scene.world.items, cell), merge_items(scene.world.roofs, cell),
          merge_items(scene.robot, cell), cell};
}

/// The finest meshes within the limit.
SceneMeshes fit_scene(const PageScene& scene, std::size_t most_bytes) {
  SceneMeshes meshes = merge_scene(scene, 0.0F);
  for (float cell = kFirstCell; meshes.bytes() > most_bytes && cell < kLastCell; cell *= 2.0F) {
    meshes = merge_scene(scene, cell);
  }
  return meshes;
}

SceneJson changing_json(const std::map<std::string, PageStates>& changing, float cell) {
  SceneJson json;
  for (const auto& [name, states] : changing) {
    SceneJson& list = json[name] = SceneJson::array();
    for (const std::vector<sim::SceneItem>& items : states) {
      list.push_back(items.empty() ? SceneJson() : mesh_json(merge_items(items, cell)));
    }
  }
  return json;
}

}  // namespace

std::string page_scene_json(const PageScene& scene, std::size_t most_bytes) {
  const PageWorld& world = scene.world;
  const SceneMeshes meshes = fit_scene(scene, most_bytes);
  const Eigen::Vector3f& floor = world.floor_color;
  SceneJson json = {
      {"extent",
       {world.min_corner.x(), world.min_corner.y(), world.max_corner.x(), world.max_corner.y()}},
      {"top", world.top},
      {"floor", {floor.x(), floor.y(), floor.z()}},
      {"world", mesh_json(meshes.world)},
      {"roof", world.roofs.empty() ? SceneJson() : mesh_json(meshes.roof)},
      {"robot", mesh_json(meshes.robot)},
      {"ghost", mesh_json(merge_items(scene.robot, std::max(kGhostCell, meshes.cell)))},
      {"person", person_json(scene.people)},
      {"thinned_m", meshes.cell}};
  if (!scene.changing.empty()) json["changing"] = changing_json(scene.changing, meshes.cell);
  return json_text(json);
}

}  // namespace castaway::testbed
