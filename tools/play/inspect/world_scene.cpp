#include "tools/play/inspect/world_scene.hpp"

#include <algorithm>
#include <cmath>

#include "sim/scene/camera.hpp"
#include "sim/scene/primitives.hpp"
#include "sim/scene/scene.hpp"
#include "sim/world/world_visuals.hpp"
#include "tools/build/scene/visible_scene.hpp"
#include "tools/outputs/pictures/palette.hpp"
#include "tools/outputs/pictures/picture_scenes.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

const Vector3f kRouteColor = scene_color(0x0072B2);
const Vector3f kSlipColor = scene_color(0xE69F00);

/// A closed polyline.
sim::SceneLines outline(const std::vector<Eigen::Vector2d>& points, const Vector3f& color) {
  sim::SceneLines lines{{}, color, 2.0F};
  for (std::size_t i = 0; i < points.size(); ++i) {
    lines.points.push_back(sim::raise_point(points[i], 0.02F));
    lines.points.push_back(sim::raise_point(points[(i + 1) % points.size()], 0.02F));
  }
  return lines;
}

void add_marks(const LoadedWorld& world, sim::Scene& scene) {
  for (const auto& [name, route] : world.file.routes) {
    scene.lines.push_back(outline(route, kRouteColor));
  }
  for (const sim::SlipZone& zone : world.file.spec.slip_zones) {
    scene.lines.push_back(outline(zone.outline, kSlipColor));
  }
  if (!world.has_start) return;
  sim::SceneItem arrow;
  arrow.mesh = sim::arrow_mesh(0.9F, 0.5F);
  arrow.T_map_mesh = sim::to_isometry(world.file.start).cast<float>();
  arrow.T_map_mesh.translation().z() = 0.03F;
  arrow.color = scene_color(0xD55E00);
  arrow.shaded = false;
  scene.items.push_back(std::move(arrow));
}

}  // namespace

sim::Scene world_scene(const LoadedWorld& world) {
  sim::Scene scene;
  const sim::WorldSpec& spec = world.file.spec;
  scene.items = sim::world_visuals_from_above(spec);
  scene.items.push_back(floor_item(spec));
  add_marks(world, scene);
  const Eigen::Vector2f size = (spec.max_corner - spec.min_corner).cast<float>();
  const float reach = 1.06F * std::max(size.x(), 1.25F * size.y());
  scene.camera.target = sim::raise_point(0.5 * (spec.min_corner + spec.max_corner), 0.0F);
  scene.camera.target.y() -= 0.06F * size.y();
  scene.camera.eye = scene.camera.target + reach * Vector3f(-0.04F, -0.62F, 0.95F);
  scene.camera.fov_y_deg = 42.0F;
  const float top = sim::standing_height(scene.items);
  scene.camera = sim::step_back(
      scene.camera,
      {sim::raise_point(spec.min_corner, 0.0F), sim::raise_point(spec.max_corner, top)},
      4.0F / 3.0F);
  return scene;
}

sim::Scene world_map_scene(const LoadedWorld& world) {
  sim::Scene scene;
  const RosMap shown = known_part(world.map);
  scene.items.push_back(map_item(shown));
  add_marks(world, scene);
  Eigen::AlignedBox2d box;
  for (const int column : {0, shown.width}) {
    for (const int row : {0, shown.height}) box.extend(shown.to_map(Eigen::Vector2d(column, row)));
  }
  const Eigen::Vector2f size = box.sizes().cast<float>();
  scene.camera.target = sim::raise_point(box.center(), 0.0F);
  scene.camera.eye = scene.camera.target + Vector3f(0.0F, 0.0F, 50.0F);
  scene.camera.up = Vector3f::UnitY();
  scene.camera.ortho_height = 1.04F * std::max(size.y(), size.x() * 0.75F);
  return scene;
}

}  // namespace castaway::testbed
