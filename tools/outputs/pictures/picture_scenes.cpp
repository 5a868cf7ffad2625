#include "tools/outputs/pictures/picture_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/scene/camera.hpp"
#include "sim/scene/primitives.hpp"
#include "tools/outputs/pictures/chase_view.hpp"
#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/outputs/pictures/palette.hpp"
#include "tools/outputs/pictures/pose_marks.hpp"

namespace castaway::testbed {
namespace {

constexpr double kHead = 2.0;  // [m] Room for people on a floor.

using Eigen::Vector3f;

const Vector3f kHitColor{0.85F, 0.10F, 0.15F};
constexpr float kAspect = 4.0F / 3.0F;  // Of the narrowest image for which overviews are framed.

/// Adds a person on the map: an ellipse for the body, with a nose.
void add_person(const PersonTruth& person, sim::Scene& scene) {
  constexpr int kSides = 20;
  constexpr double kDepth = 0.16;   // [m]
  constexpr double kWidth = 0.225;  // [m]
  sim::SceneLines outline{{}, scene_color(kPeopleColor), 2.0F};
  for (int side = 0; side < kSides; ++side) {
    for (const int end : {side, side + 1}) {
      const double angle = 2.0 * std::numbers::pi * end / kSides;
      const Eigen::Vector2d p(kDepth * std::cos(angle), kWidth * std::sin(angle));
      outline.points.push_back(sim::raise_point(person.T_map_person * p, 0.15));
    }
  }
  for (const double x : {0.0, 1.6 * kDepth}) {
    outline.points.push_back(sim::raise_point(person.T_map_person * Eigen::Vector2d(x, 0.0), 0.15));
  }
  scene.lines.push_back(std::move(outline));
}

/// Adds each localizer's estimate as a ring and an arrow on the floor, or near the robot on the
/// ground that carries it.
void add_ghosts(const PictureWorld& world, const ScanRecord& record, double height,
                sim::Scene& scene) {
  constexpr double kFloor = 0.02;  // [m] Above the floor.
  constexpr double kNear = 1.0;    // [m]
  const std::vector<std::size_t> styles = localizer_styles(record);
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    const auto& estimate = record.localizers[i].estimate;
    if (!estimate) continue;
    const bool near = distance(estimate->T_map_base, record.true_pose->T_map_base) < kNear;
    double ground = near ? height : 0.0;
    if (record.has_heights()) ground = estimate->footing ? estimate->footing->z : 0.0;
    add_pose(estimate->T_map_base, 1.2 * world.robot_radius,
             scene_color(palette_color(kLocalizerColors, styles[i])),
             kFloor + ground + 0.004 * static_cast<double>(i), scene);
  }
}

Eigen::AlignedBox3f tight_bounds(const sim::SceneItem& item) {
  Eigen::AlignedBox3f box;
  for (const Vector3f& vertex : item.mesh.vertices) box.extend(item.T_map_mesh * vertex);
  return box;
}

/// True if there is ground beneath a box's middle or corners, with room for people.
bool hangs_over_ground(const PictureWorld& world, const Eigen::AlignedBox3f& box) {
  const Vector3f& low = box.min();
  const Vector3f& high = box.max();
  const Vector3f middle = box.center();
  for (const Eigen::Vector2f& p :
       {Eigen::Vector2f(middle.x(), middle.y()), Eigen::Vector2f(low.x(), low.y()),
        Eigen::Vector2f(high.x(), low.y()), Eigen::Vector2f(low.x(), high.y()),
        Eigen::Vector2f(high.x(), high.y())}) {
    const auto ground = world.lowest_ground(p.cast<double>());
    if (ground && *ground < static_cast<double>(low.z()) - kHead) return true;
  }
  return false;
}

/// Without the floors above one, and what stands on them.
std::vector<sim::SceneItem> below_the_next_floor(const PictureWorld& world, double floor) {
  std::vector<sim::SceneItem> items = world.world;
  std::erase_if(items, [&](const sim::SceneItem& item) {
    const Eigen::AlignedBox3f box = tight_bounds(item);
    return static_cast<double>(box.min().z()) > floor + kHead && hangs_over_ground(world, box);
  });
  return items;
}

/// The objects to show in an overview: those without roofs, or up to the robot's floor.
std::vector<sim::SceneItem> seen_from_above(const PictureWorld& world, const ScanRecord& record) {
  if (record.has_heights() && world.lowest_ground) {
    return below_the_next_floor(world, record.true_pose->z());
  }
  return world.from_above.empty() ? world.world : world.from_above;
}

/// The static and the moving objects, without the robot.
std::vector<sim::SceneItem> surroundings(const PictureWorld& world,
                                         std::vector<sim::SceneItem> items) {
  if (world.moving) {
    for (sim::SceneItem& item : world.moving()) items.push_back(std::move(item));
  }
  return items;
}

/// `items`, the robot at its true pose, and lidar hits.
sim::Scene base_scene(const PictureWorld& world, std::vector<sim::SceneItem> items,
                      const ScanRecord& record, const std::optional<SE2>& T_map_now) {
  sim::Scene scene;
  scene.items = std::move(items);
  if (!record.true_pose) return scene;
  const Eigen::Isometry3d T_map_base =
      pose_in_space(world, T_map_now.value_or(record.true_pose->T_map_base));
  for (sim::SceneItem item : world.robot) {
    item.T_map_mesh = T_map_base.cast<float>() * item.T_map_mesh;
    scene.items.push_back(std::move(item));
  }
  const Eigen::Isometry3d T_map_base_at_scan = pose_in_space(world, record.true_pose->T_map_base);
  scene.points.push_back({lidar_hits(record.scan, T_map_base_at_scan), kHitColor, 4.0F});
  add_ghosts(world, record, T_map_base.translation().z(), scene);
  return scene;
}

void add_particles(const localization::PopulationView& population, std::uint32_t color,
                   sim::Scene& scene) {
  sim::ScenePoints points;
  points.color = population_color(color, population.id);
  points.size_px = population.selected ? 3.0F : 2.0F;
  for (const SE2& particle : population.particles) {
    points.points.push_back(sim::raise_point(particle.translation(), 0.1));
  }
  scene.points.push_back(std::move(points));
}

Eigen::AlignedBox2d box_of(const RosMap& map) {
  Eigen::AlignedBox2d bounds;
  for (const int column : {0, map.width}) {
    for (const int row : {0, map.height}) bounds.extend(map.to_map(Eigen::Vector2d(column, row)));
  }
  return bounds;
}

/// A camera that looks straight down on the map, as large as the image allows.
sim::Camera camera_above(const RosMap& map, const MapView& view) {
  const double height = map_height(map, view);
  const Eigen::Vector2d middle =
      box_of(map).center() - Eigen::Vector2d(0.0, 0.5 * view.below * height);
  sim::Camera camera;
  camera.target = sim::raise_point(middle, 0.0);
  camera.eye = sim::raise_point(middle, 50.0);
  camera.up = Vector3f::UnitY();
  camera.ortho_height = static_cast<float>(height);
  return camera;
}

}  // namespace

Eigen::Isometry3d pose_in_space(const PictureWorld& world, const SE2& T_map_footprint) {
  const Eigen::Isometry3d T_map_base = localization::to_se3(T_map_footprint);
  return world.T_footprint_base ? T_map_base * world.T_footprint_base() : T_map_base;
}

std::vector<Vector3f> lidar_hits(const LaserScan& scan, const Eigen::Isometry3d& T_map_base) {
  const Eigen::Isometry3d T_map_laser = T_map_base * scan.T_base_laser;
  std::vector<Vector3f> hits;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (!std::isfinite(scan.ranges[i])) continue;
    const double angle = scan.beam_angle(i);
    const Eigen::Vector3d p_laser(std::cos(angle), std::sin(angle), 0.0);
    hits.emplace_back((T_map_laser * (scan.ranges[i] * p_laser)).cast<float>());
  }
  return hits;
}

sim::Scene chase_scene(const PictureWorld& world, const ScanRecord& record,
                       const std::optional<SE2>& T_map_now) {
  std::vector<sim::SceneItem> items = surroundings(world, world.world);
  const SE2 T_map_base = T_map_now.value_or(T_map_base_of(record.true_pose).value_or(SE2{}));
  const double height = pose_in_space(world, T_map_base).translation().z();
  const ChaseView view = clear_view(items, T_map_base, static_cast<float>(height));
  sim::Scene scene = base_scene(world, std::move(items), record, T_map_now);
  scene.camera.eye = view.eye;
  scene.camera.target = view.target;
  scene.camera.fov_y_deg = 60.0F;
  return scene;
}

sim::Scene overview_scene(const PictureWorld& world, const ScanRecord& record,
                          const std::optional<SE2>& T_map_now) {
  std::vector<sim::SceneItem> items = surroundings(world, seen_from_above(world, record));
  sim::Scene scene = base_scene(world, std::move(items), record, T_map_now);
  const Eigen::Vector2d center = 0.5 * (world.min_corner + world.max_corner);
  const double size = (world.max_corner - world.min_corner).maxCoeff();
  scene.camera.target = sim::raise_point(center - Eigen::Vector2d(0.0, 0.04 * size), 0.0);
  scene.camera.eye = sim::raise_point(center - Eigen::Vector2d(0.0, 0.68 * size), 1.08 * size);
  scene.camera.fov_y_deg = 45.0F;
  scene.camera = sim::step_back(
      scene.camera,
      {sim::raise_point(world.min_corner, 0.0), sim::raise_point(world.max_corner, world.top)},
      kAspect);
  return scene;
}

double map_height(const RosMap& map, const MapView& view) {
  const Eigen::Vector2d sizes = box_of(map).sizes();
  return 1.02 * std::max(sizes.y() / (1.0 - view.below), sizes.x() / view.aspect);
}

sim::Scene map_scene(const PictureWorld& world, const sim::SceneItem& map_item,
                     const ScanRecord& record, const MapView& view) {
  sim::Scene scene;
  scene.background = Vector3f::Constant(0.80F);
  scene.camera = camera_above(*world.map, view);
  scene.items.push_back(map_item);
  const double radius = std::max(world.robot_radius, 0.012 * scene.camera.ortho_height);
  double z = 0.2;  // Later outlines are drawn above earlier ones.
  const std::vector<std::size_t> styles = localizer_styles(record);
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    for (const auto& population : record.localizers[i].diagnostics.populations) {
      add_particles(population, palette_color(kLocalizerColors, styles[i]), scene);
    }
  }
  for (const PersonTruth& person : record.people.people) add_person(person, scene);
  if (record.true_pose) add_truth(record.true_pose->T_map_base, radius, scene);
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    const auto& estimate = record.localizers[i].estimate;
    const Vector3f color = scene_color(palette_color(kLocalizerColors, styles[i]));
    if (estimate) add_pose(estimate->T_map_base, radius, color, z += 0.1, scene);
  }
  return scene;
}

}  // namespace castaway::testbed
