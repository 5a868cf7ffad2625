#include "tools/play/inspect/robot_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/robot/robot_sensors.hpp"
#include "sim/robot/robot_visuals.hpp"
#include "sim/scene/primitives.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "tools/outputs/pictures/palette.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

constexpr int kCircle = 48;
constexpr float kMostTiles = 60.0F;  // From the centre.
const Vector3f kWheelColor = scene_color(0x0072B2);
const Vector3f kCasterColor = scene_color(0xE69F00);
const Vector3f kScanColor{0.85F, 0.10F, 0.15F};

/// Adds segments that connect consecutive points.
void add_path(const std::vector<Vector3f>& points, sim::SceneLines& lines) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    lines.points.push_back(points[i - 1]);
    lines.points.push_back(points[i]);
  }
}

/// A circle around a centre, spanned by two unit vectors.
std::vector<Vector3f> circle(const Vector3f& center, float radius, const Vector3f& u,
                             const Vector3f& v) {
  std::vector<Vector3f> points;
  for (int i = 0; i <= kCircle; ++i) {
    const auto angle = static_cast<float>(2.0 * std::numbers::pi * i / kCircle);
    points.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

/// Adds a chequered floor around the robot.
void add_floor(float reach, sim::Scene& scene) {
  const float edge = reach > 3.0F ? 1.0F : 0.1F;
  const int half = static_cast<int>(std::ceil(std::min(reach / edge, kMostTiles)));
  for (int i = -half; i < half; ++i) {
    for (int j = -half; j < half; ++j) {
      sim::SceneItem tile;
      const Eigen::Vector2f corner(static_cast<float>(i) * edge, static_cast<float>(j) * edge);
      tile.mesh = sim::ground_mesh(corner, corner + Eigen::Vector2f::Constant(edge));
      tile.T_map_mesh.translation().z() = -0.002F;
      tile.color = Vector3f::Constant((i + j) % 2 == 0 ? 0.86F : 0.80F);
      tile.casts_shadow = false;
      scene.items.push_back(std::move(tile));
    }
  }
}

void add_axes(float length, sim::Scene& scene) {
  for (int axis = 0; axis < 3; ++axis) {
    Vector3f color = Vector3f::Constant(0.1F);
    color[axis] = 0.8F;
    scene.lines.push_back({{Vector3f::Zero(), length * Vector3f::Unit(axis)}, color, 3.0F});
  }
}

void add_supports(const sim::RobotModel& robot, sim::Scene& scene) {
  sim::SceneLines wheels{{}, kWheelColor, 2.5F};
  for (const sim::DriveWheel& wheel : robot.wheels) {
    add_path(circle(wheel.p_base_wheel.cast<float>(), static_cast<float>(wheel.radius),
                    Vector3f::UnitX(), Vector3f::UnitZ()),
             wheels);
  }
  sim::SceneLines casters{{}, kCasterColor, 2.5F};
  for (const sim::Caster& caster : robot.casters) {
    add_path(circle(caster.p_base_caster.cast<float>(), static_cast<float>(caster.radius),
                    Vector3f::UnitX(), Vector3f::UnitZ()),
             casters);
  }
  scene.lines.push_back(std::move(wheels));
  scene.lines.push_back(std::move(casters));
}

/// Adds the arc of a lidar's field of view, with its first and last beam.
void add_scan(const sim::LidarConfig& lidar, float reach, sim::Scene& scene) {
  const Eigen::Isometry3f T_base_laser = lidar.T_base_laser.cast<float>();
  std::vector<Vector3f> arc{T_base_laser.translation()};
  for (int i = 0; i <= 2 * kCircle; ++i) {
    const double beam = static_cast<double>(lidar.beams - 1) * i / (2 * kCircle);
    const auto angle = static_cast<float>(lidar.angle_min + beam * lidar.angle_increment);
    arc.push_back(T_base_laser * Vector3f(reach * std::cos(angle), reach * std::sin(angle), 0.0F));
  }
  arc.push_back(T_base_laser.translation());
  sim::SceneLines lines{{}, kScanColor, 1.5F};
  add_path(arc, lines);
  scene.lines.push_back(std::move(lines));
}

}  // namespace

sim::Scene robot_scene(const sim::RobotModel& robot) {
  sim::Scene scene;
  scene.items = sim::robot_visuals(robot);
  for (sim::SceneItem& item : sim::lidar_visuals(robot, sim::lidar_of(robot))) {
    scene.items.push_back(std::move(item));
  }
  const auto radius = static_cast<float>(robot.footprint_radius);
  const auto height = static_cast<float>(robot.height);
  const float size = std::max(2.0F * radius, height);
  add_floor(1.6F * std::max(radius, 0.5F * size), scene);
  add_axes(0.6F * size, scene);
  add_supports(robot, scene);
  for (const sim::LidarConfig& lidar : sim::lidars_of(robot)) add_scan(lidar, 1.1F * radius, scene);
  scene.camera.target = {0.0F, 0.0F, 0.42F * height};
  scene.camera.eye = scene.camera.target + 1.75F * size * Vector3f(0.72F, 0.52F, 0.42F);
  scene.camera.fov_y_deg = 45.0F;
  return scene;
}

}  // namespace castaway::testbed
