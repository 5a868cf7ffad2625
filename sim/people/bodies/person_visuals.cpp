#include "sim/people/bodies/person_visuals.hpp"

#include <array>

#include "sim/scene/primitives.hpp"

namespace castaway::sim {
namespace {

using Eigen::Vector3f;

const Vector3f kSkinColor{0.87F, 0.68F, 0.55F};
const Vector3f kShoe{0.16F, 0.14F, 0.13F};
const std::array<Vector3f, 6> kCoats = {
    Vector3f{0.72F, 0.25F, 0.22F}, Vector3f{0.20F, 0.42F, 0.62F}, Vector3f{0.85F, 0.65F, 0.23F},
    Vector3f{0.30F, 0.52F, 0.36F}, Vector3f{0.48F, 0.36F, 0.58F}, Vector3f{0.42F, 0.43F, 0.46F}};
const std::array<Vector3f, 3> kTrousers = {
    Vector3f{0.22F, 0.25F, 0.33F}, Vector3f{0.35F, 0.29F, 0.24F}, Vector3f{0.15F, 0.15F, 0.17F}};

/// Numbers of sides of round parts.
struct Sides {
  double share;

  [[nodiscard]] int of(int sides) const { return static_cast<int>(std::lround(share * sides)); }
};

/// Stretches a mesh; normals stay unit and upright to the surface.
TriangleMesh stretch(TriangleMesh mesh, const Vector3f& by) {
  for (Vector3f& v : mesh.vertices) v = v.cwiseProduct(by);
  for (Vector3f& n : mesh.normals) n = n.cwiseQuotient(by).normalized();
  return mesh;
}

SceneItem item(TriangleMesh mesh, const Eigen::Vector2d& p_map, double z, double heading,
               const Vector3f& color) {
  SceneItem result;
  result.mesh = std::move(mesh);
  result.T_map_mesh = (Eigen::Translation3d(p_map.x(), p_map.y(), z) *
                       Eigen::Isometry3d(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ())))
                          .cast<float>();
  result.color = color;
  return result;
}

/// A shin, upright as the lidar meets it, and a thigh up to the hip.
void add_leg(const PersonBody& body, const Eigen::Vector2d& foot, const Eigen::Vector2d& hip,
             const Vector3f& color, const Sides& sides, std::vector<SceneItem>& items) {
  const auto radius = static_cast<float>(body.leg_radius);
  items.push_back(item(cylinder_mesh(radius, static_cast<float>(kTorsoBottom), sides.of(16)), foot,
                       0.5 * kTorsoBottom, 0.0, color));
  items.push_back(item(sphere_mesh(radius, sides.of(6)), foot, kTorsoBottom, 0.0, color));
  const Eigen::Vector3d knee(foot.x(), foot.y(), kTorsoBottom);
  const Eigen::Vector3d thigh = Eigen::Vector3d(hip.x(), hip.y(), kHipHeight) - knee;
  SceneItem upper = item(cylinder_mesh(radius, static_cast<float>(thigh.norm()), sides.of(16)),
                         foot, 0.0, 0.0, color);
  const Eigen::Vector3d middle = knee + 0.5 * thigh;
  upper.T_map_mesh =
      (Eigen::Translation3d(middle) *
       Eigen::Isometry3d(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), thigh)))
          .cast<float>();
  items.push_back(std::move(upper));
}

}  // namespace

std::vector<SceneItem> person_visuals(const PersonBody& body, const PersonState& state, int index,
                                      double roundness) {
  const Sides sides{roundness};
  const auto number = static_cast<std::size_t>(index);
  const Vector3f& coat = kCoats[number % kCoats.size()];
  const Vector3f& trousers = kTrousers[number / kCoats.size() % kTrousers.size()];
  const double shoulders = body.height - kHeadHeight;
  const double yaw = state.heading;
  const Eigen::Vector2d ahead = heading_vector(yaw);
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  std::vector<SceneItem> items;
  for (const std::size_t side : {0U, 1U}) {
    const Eigen::Vector2d& foot = state.feet[side];
    const Eigen::Vector2d hip = state.position + (side == 0 ? kHipSide : -kHipSide) * left;
    items.push_back(item(box_mesh({0.26F, 0.1F, 0.09F}), foot + 0.05 * ahead, 0.045, yaw, kShoe));
    add_leg(body, foot, hip, trousers, sides, items);
  }
  const auto length = static_cast<float>(shoulders - kTorsoBottom);
  const double middle = 0.5 * (shoulders + kTorsoBottom);
  const auto depth = static_cast<float>(kTorsoHalfDepth);
  const auto width = static_cast<float>(kTorsoHalfWidth - 0.045);
  items.push_back(item(stretch(cylinder_mesh(1.0F, length, sides.of(24)), {depth, width, 1.0F}),
                       state.position, middle, yaw, coat));
  items.push_back(item(stretch(sphere_mesh(1.0F, sides.of(8)), {depth, width, 0.08F}),
                       state.position, shoulders, yaw, coat));
  for (const double side : {1.0, -1.0}) {
    items.push_back(item(cylinder_mesh(0.045F, 0.62F, sides.of(12)),
                         state.position + side * (kTorsoHalfWidth - 0.045) * left, shoulders - 0.31,
                         yaw, 0.85F * coat));
  }
  const auto head = static_cast<float>(kHeadRadius);
  items.push_back(item(stretch(sphere_mesh(1.0F, sides.of(8)), {head, 0.9F * head, 1.25F * head}),
                       state.position, body.height - 1.25 * kHeadRadius, yaw, kSkinColor));
  items.push_back(
      item(stretch(sphere_mesh(1.0F, sides.of(8)), {0.9F * head, 0.95F * head, 0.9F * head}),
           state.position - 0.025 * ahead, body.height - 0.8 * kHeadRadius, yaw, kShoe));
  for (SceneItem& part : items) {
    part.instance = static_cast<std::uint16_t>(kFirstPersonInstance + index);
  }
  return items;
}

}  // namespace castaway::sim
