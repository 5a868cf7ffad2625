#include "tools/outputs/pictures/pose_marks.hpp"

#include <cmath>
#include <numbers>

#include "sim/scene/primitives.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;
using localization::SE2;

const Vector3f kTruthColor{0.0F, 0.0F, 0.0F};

/// Adds a circular outline on the map.
void add_circle(const SE2& T_map_base, double radius, double z, sim::SceneLines outline,
                sim::Scene& scene) {
  constexpr int kSides = 32;
  for (int side = 0; side < kSides; ++side) {
    for (const int end : {side, side + 1}) {
      const double angle = 2.0 * std::numbers::pi * end / kSides;
      const Eigen::Vector2d p_base = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const Eigen::Vector2d p = T_map_base * p_base;
      outline.points.push_back(sim::raise_point(p, z));
    }
  }
  scene.lines.push_back(std::move(outline));
}

/// Adds an arrow on the map, starting at the centre of the pose.
void add_arrow(const SE2& T_map_base, double radius, const Vector3f& color, double z,
               sim::Scene& scene) {
  sim::SceneItem arrow;
  arrow.mesh = sim::arrow_mesh(static_cast<float>(1.8 * radius), static_cast<float>(radius));
  arrow.T_map_mesh = localization::to_se3(T_map_base).cast<float>();
  arrow.T_map_mesh.translation().z() = static_cast<float>(z);
  arrow.color = color;
  arrow.shaded = false;
  scene.items.push_back(std::move(arrow));
}

}  // namespace

void add_pose(const SE2& T_map_base, double radius, const Vector3f& color, double z,
              sim::Scene& scene) {
  add_circle(T_map_base, radius, z, {{}, color, 2.5F}, scene);
  add_arrow(T_map_base, radius, color, z, scene);
}

void add_truth(const SE2& T_map_base, double radius, sim::Scene& scene) {
  const double wide = 1.5 * radius;
  const SE2 T_base_behind{-0.12 * wide, 0.0, 0.0};
  add_circle(T_map_base, wide, 0.18, {{}, Vector3f::Ones(), 8.0F}, scene);
  add_arrow(T_map_base * T_base_behind, 1.25 * wide, Vector3f::Ones(), 0.185, scene);
  add_circle(T_map_base, wide, 0.19, {{}, kTruthColor, 4.0F}, scene);
  add_arrow(T_map_base, wide, kTruthColor, 0.2, scene);
}

}  // namespace castaway::testbed
