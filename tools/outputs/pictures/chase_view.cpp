#include "tools/outputs/pictures/chase_view.hpp"

#include <array>
#include <cmath>

#include "sim/scene/primitives.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

/// Candidate camera positions [m] in base: behind (negative x), beside, above.
constexpr std::array<std::array<float, 3>, 10> kPlaces{{{-1.9F, 0.0F, 1.7F},
                                                        {-1.4F, 0.0F, 2.0F},
                                                        {-1.4F, 0.9F, 1.9F},
                                                        {-1.4F, -0.9F, 1.9F},
                                                        {-0.9F, 0.0F, 2.4F},
                                                        {-0.9F, 0.0F, 1.4F},
                                                        {0.0F, 1.6F, 1.9F},
                                                        {0.0F, -1.6F, 1.9F},
                                                        {1.8F, 0.0F, 1.8F},
                                                        {-0.5F, 0.0F, 2.8F}}};

/// Moeller, Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997. A hit counts only
/// strictly between the ends.
bool cuts(const std::array<Vector3f, 3>& corner, const Vector3f& from, const Vector3f& way) {
  const Vector3f edge1 = corner[1] - corner[0];
  const Vector3f edge2 = corner[2] - corner[0];
  const Vector3f p = way.cross(edge2);
  const float determinant = edge1.dot(p);
  if (std::abs(determinant) < 1e-12F) return false;
  const Vector3f offset = from - corner[0];
  const float u = offset.dot(p) / determinant;
  if (u < 0.0F || u > 1.0F) return false;
  const Vector3f q = offset.cross(edge1);
  const float v = way.dot(q) / determinant;
  if (v < 0.0F || u + v > 1.0F) return false;
  const float along = edge2.dot(q) / determinant;
  return along > 0.0F && along < 1.0F;
}

bool hides(const sim::SceneItem& item, const Vector3f& from, const Vector3f& to) {
  const Eigen::Isometry3f T_mesh_map = item.T_map_mesh.inverse();
  const Vector3f start = T_mesh_map * from;
  const Vector3f way = T_mesh_map.linear() * (to - from);
  const auto& mesh = item.mesh;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array<Vector3f, 3> corner{mesh.vertices[mesh.indices[i]],
                                         mesh.vertices[mesh.indices[i + 1]],
                                         mesh.vertices[mesh.indices[i + 2]]};
    if (cuts(corner, start, way)) return true;
  }
  return false;
}

constexpr float kHeight = 0.25F;  // [m] Height at which the robot must be visible.
constexpr float kSide = 0.2F;     // [m] Distance from the centre at which it must be visible, too.

/// Pose of the robot on the ground.
struct Stand {
  localization::SE2 T_map_base;
  float height;  ///< [m]

  [[nodiscard]] Vector3f at(float x, float y, float z) const {
    const Eigen::Vector2d p = T_map_base * Eigen::Vector2d(x, y);
    return sim::raise_point(p, height + z);
  }
};

}  // namespace

bool is_hidden(const std::vector<sim::SceneItem>& items, const Vector3f& from, const Vector3f& to) {
  for (const sim::SceneItem& item : items) {
    if (hides(item, from, to)) return true;
  }
  return false;
}

namespace {

/// Whether the robot's centre and both sides are visible.
bool is_in_sight(const std::vector<sim::SceneItem>& world, const Stand& robot,
                 const Vector3f& eye) {
  for (const float y : {0.0F, kSide, -kSide}) {
    if (is_hidden(world, robot.at(0.0F, y, kHeight), eye)) return false;
  }
  return true;
}

}  // namespace

ChaseView clear_view(const std::vector<sim::SceneItem>& world, const localization::SE2& T_map_base,
                     float height) {
  const Stand robot{T_map_base, height};
  const Vector3f usual_target = robot.at(0.9F, 0.0F, 0.1F);
  for (const auto& [x, y, z] : kPlaces) {
    const Vector3f eye = robot.at(x, y, z);
    if (!is_in_sight(world, robot, eye)) continue;
    const bool ahead = x < 0.0F && !is_hidden(world, eye, usual_target);
    return {eye, ahead ? usual_target : robot.at(0.0F, 0.0F, kHeight)};
  }
  return {robot.at(-0.05F, 0.0F, 3.0F), robot.at(0.0F, 0.0F, kHeight)};
}

}  // namespace castaway::testbed
