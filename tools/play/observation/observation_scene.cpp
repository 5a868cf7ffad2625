#include "tools/play/observation/observation_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sim/scene/camera.hpp"
#include "sim/scene/primitives.hpp"
#include "sim/scene/scene.hpp"
#include "tools/outputs/pictures/chase_view.hpp"
#include "tools/play/observation/ground_items.hpp"
#include "tools/play/observation/observation_colors.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kElevation = 27.0F * std::numbers::pi_v<float> / 180.0F;
constexpr double kLeastTilt = 0.02;   // [rad] Less is no slope.
constexpr float kPointSize = 0.016F;  // Radius of an end point, as a share of the reach.
constexpr float kAhead = 2.5F;        // Radii from the end of a beam to its ball.
constexpr float kPale = 0.45F;        // Share of white in a beam's colour.
constexpr float kRobotMiddle = 0.4F;  // [m] Above its base.

void add_map(const Observation& observation, const MapWindow& window, sim::Scene& scene) {
  if (observation.planar) {
    scene.items.push_back(cost_map_item(*observation.planar, observation.model, window));
    return;
  }
  const double height = observation.T_base_laser.translation().z();
  GroundItems ground = ground_items(*observation.volume, observation.model, window, height);
  scene.items.push_back(std::move(ground.surface));
  scene.lines.push_back(std::move(ground.contours));
  scene.items.push_back(obstacles_item(*observation.volume, window));
}

void add_robot(const Observation& observation, sim::Scene& scene) {
  for (sim::SceneItem item : observation.robot) {
    item.T_map_mesh = observation.T_map_base.cast<float>() * item.T_map_mesh;
    scene.items.push_back(std::move(item));
  }
}

void add_people(const Observation& observation, const MapWindow& window, sim::Scene& scene) {
  for (const sim::SceneItem& item : observation.people) {
    if (!window.contains(item.T_map_mesh.translation().head<2>().cast<double>())) continue;
    scene.items.push_back(item);
  }
}

/// A ball before the end of a beam for the viewer, so that what the beam hit does not hide it.
sim::SceneItem end_point(const ObservedBeam& beam, const Vector3f& color, float radius,
                         const Vector3f& eye) {
  sim::SceneItem item;
  item.mesh = sim::sphere_mesh(radius, 8);
  item.T_map_mesh.translation() = beam.end + kAhead * radius * (eye - beam.end).normalized();
  item.color = color;
  item.shaded = false;
  return item;
}

/// Beams in the pale colour of their end points, as far as they are in the window; on a planar map
/// with a line down to the cell that the model looks up.
void add_beams(const Observation& observation, const MapWindow& window, sim::Scene& scene) {
  const float radius = kPointSize * static_cast<float>(window.reach);
  sim::SceneLines down{{}, Vector3f::Constant(0.55F), 1.0F};
  for (const ObservedBeam& beam : observation.beams) {
    const Vector3f color = likelihood_color(observation.model, beam.likelihood);
    const Vector3f pale = color + kPale * (Vector3f::Ones() - color);
    const auto share = static_cast<float>(window.share_inside(beam.end.head<2>().cast<double>()));
    const Vector3f end = beam.origin + std::min(share, 1.0F) * (beam.end - beam.origin);
    scene.lines.push_back({{beam.origin, end}, pale, 1.5F});
    if (share < 1.0F) continue;
    scene.items.push_back(end_point(beam, color, radius, scene.camera.eye));
    if (!observation.planar) continue;
    down.points.push_back(beam.end);
    down.points.emplace_back(beam.end.x(), beam.end.y(), 0.0F);
  }
  scene.lines.push_back(std::move(down));
}

void add_axes(const Eigen::Isometry3f& T_map_frame, float length, sim::Scene& scene) {
  for (int axis = 0; axis < 3; ++axis) {
    Vector3f color = Vector3f::Constant(0.05F);
    color[axis] = 0.85F;
    scene.lines.push_back(
        {{T_map_frame.translation(), T_map_frame * (length * Vector3f::Unit(axis))}, color, 2.0F});
  }
}

/// Yaw in map of the picture's right side. On a slope the viewer looks along its contour lines,
/// from the southern side; else to the north.
double yaw_of_view(const Observation& observation) {
  const Vector3d up = observation.T_map_base.linear().col(2);
  if (up.head<2>().norm() < kLeastTilt) return 0.0;
  const double downhill = std::atan2(up.y(), up.x());
  return std::cos(downhill) > 0.0 ? downhill : downhill + std::numbers::pi;
}

bool shows(const sim::Camera& camera, const std::vector<Vector3f>& points, float aspect) {
  constexpr float kRim = 0.98F;  // Share of the picture.
  const Eigen::Matrix4f clip_from_map = sim::clip_from_map(camera, aspect);
  return std::ranges::all_of(points, [&](const Vector3f& point) {
    const Eigen::Vector4f clip = clip_from_map * point.homogeneous();
    return clip.w() > 0.0F && clip.head<2>().cwiseAbs().maxCoeff() <= kRim * clip.w();
  });
}

/// A camera that shows the ground in the window, as large as the image allows.
sim::Camera camera_of(const MapWindow& window, const sim::SceneItem& ground, float aspect) {
  constexpr float kStep = 1.01F;
  const double yaw = window.T_map_window.yaw;
  const Vector3f side = sim::raise_point({std::sin(yaw), -std::cos(yaw)}, 0.0);
  const Vector3f back = std::cos(kElevation) * side + std::sin(kElevation) * Vector3f::UnitZ();
  sim::Camera camera;
  camera.target = sim::bounds_of(ground).center();
  camera.fov_y_deg = 28.0F;
  for (float distance = 1.0F; distance < 1e4F; distance *= kStep) {
    camera.eye = camera.target + distance * back;
    if (shows(camera, ground.mesh.vertices, aspect)) break;
  }
  return camera;
}

}  // namespace

sim::Scene observation_scene(const Observation& observation, const ObservationView& view) {
  const Vector3d middle = observation.T_map_base.translation();
  const double yaw = yaw_of_view(observation);
  sim::Scene scene;
  scene.background = Vector3f::Ones();
  MapWindow window;
  for (const double turn : {0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2}) {  // Until the robot is seen.
    window = {{middle.x(), middle.y(), yaw + turn}, middle.z(), view.reach};
    scene.items.clear();
    scene.lines.clear();
    add_map(observation, window, scene);
    scene.camera = camera_of(window, scene.items.front(), view.aspect);
    const Vector3f robot = middle.cast<float>() + kRobotMiddle * Vector3f::UnitZ();
    const bool hidden = is_hidden(scene.items, robot, scene.camera.eye) ||
                        is_hidden(observation.people, robot, scene.camera.eye);
    if (!hidden) break;
  }
  add_robot(observation, scene);
  add_people(observation, window, scene);
  const auto length = 0.75F * static_cast<float>(observation.robot_size);
  add_axes(observation.T_map_base.cast<float>(), length, scene);
  add_axes((observation.T_map_base * observation.T_base_laser).cast<float>(), 0.5F * length, scene);
  add_beams(observation, window, scene);
  return scene;
}

}  // namespace castaway::testbed
