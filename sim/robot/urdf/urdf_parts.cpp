#include "sim/robot/urdf/urdf_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/world/mesh.hpp"

namespace castaway::sim {
namespace {

constexpr double kDefaultEdge = 0.05;     // [m] Of the box that replaces a missing mesh.
constexpr double kLeastDensity = 50.0;    // [kg/m^3]
constexpr double kMostDensity = 12000.0;  // [kg/m^3]
constexpr float kMaxMeshSize = 15.0F;     // [m] A larger mesh is in millimetres.
constexpr double kMaxPrimitive = 1000.0;  // [m]

Eigen::Vector3d to_vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

/// The solid box with the link's mass and inertia; a small cube if its density is implausible,
/// because the values are made up.
BoxShape inertia_box(const urdf::Link& link) {
  BoxShape cube{Eigen::Vector3d::Constant(kDefaultEdge)};
  if (!link.inertial || link.inertial->mass <= 0.0) return cube;
  const Eigen::Vector3d moments(link.inertial->ixx, link.inertial->iyy, link.inertial->izz);
  BoxShape box = cube;
  for (int axis = 0; axis < 3; ++axis) {
    const double squared = 6.0 * (moments.sum() - 2.0 * moments[axis]) / link.inertial->mass;
    if (squared > 0.0) box.size[axis] = std::clamp(std::sqrt(squared), 0.01, 1.0);
  }
  const double density = link.inertial->mass / box.size.prod();
  return density > kLeastDensity && density < kMostDensity ? box : cube;
}

/// A shape, and whether it replaces a mesh.
struct FoundShape {
  RobotShape shape;
  std::string problem;    ///< Empty if the shape is as in the file.
  bool stand_in = false;  ///< A box that replaces a mesh.
};

/// Scales a mesh from millimetres to metres if it is implausibly large.
FoundShape in_metres(MeshShape shape, const urdf::Link& link) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& v : load_mesh(shape.path, shape.scale).vertices) box.extend(v);
  if (box.sizes().maxCoeff() < kMaxMeshSize) return {shape, ""};
  const std::string what =
      fmt::format("link {}: the mesh {} is {:.0f} m wide: taken for millimetres", link.name,
                  shape.path, box.sizes().maxCoeff());
  shape.scale *= 0.001;
  return {shape, what};
}

FoundShape mesh_shape(const urdf::Mesh& mesh, const urdf::Link& link, const MeshFinder& finder) {
  std::optional<std::string> path;
  try {
    path = finder.find(mesh.filename);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(
        fmt::format("link {}: mesh {}: {}", link.name, mesh.filename, error.what()));
  }
  if (!path) {
    return {inertia_box(link),
            fmt::format("link {}: no mesh {}: a box replaces it; name the folder above its package "
                        "with --search-path",
                        link.name, mesh.filename),
            true};
  }
  try {
    return in_metres({*path, to_vector(mesh.scale)}, link);
  } catch (const std::runtime_error& error) {
    return {inertia_box(link),
            fmt::format("link {}: {}: a box replaces it", link.name, error.what()), true};
  }
}

FoundShape primitive(const urdf::Geometry& geometry) {
  if (geometry.type == urdf::Geometry::SPHERE) {
    return {SphereShape{static_cast<const urdf::Sphere&>(geometry).radius}, ""};
  }
  if (geometry.type == urdf::Geometry::BOX) {
    return {BoxShape{to_vector(static_cast<const urdf::Box&>(geometry).dim)}, ""};
  }
  const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
  return {CylinderShape{cylinder.radius, cylinder.length}, ""};
}

/// The edges or diameters of a primitive. [m]
Eigen::Vector3d extent(const RobotShape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->size;
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    return Eigen::Vector3d::Constant(2.0 * sphere->radius);
  }
  const auto& cylinder = std::get<CylinderShape>(shape);
  return {2.0 * cylinder.radius, 2.0 * cylinder.radius, cylinder.height};
}

/// Converts a geometry; nothing, with a warning, for shapes without volume, which some files use as
/// placeholders.
std::optional<FoundShape> to_shape(const urdf::Geometry& geometry, const urdf::Link& link,
                                   const MeshFinder& finder, std::vector<std::string>& warnings) {
  if (geometry.type == urdf::Geometry::MESH) {
    return mesh_shape(static_cast<const urdf::Mesh&>(geometry), link, finder);
  }
  FoundShape found = primitive(geometry);
  const Eigen::Vector3d size = extent(found.shape);
  if (!(size.minCoeff() >= 0.0 && size.maxCoeff() < kMaxPrimitive)) {
    throw std::runtime_error(
        fmt::format("link {}: a shape of {} x {} x {} m: give sizes above 0 and below {}",
                    link.name, size.x(), size.y(), size.z(), kMaxPrimitive));
  }
  if (size.minCoeff() > 0.0) return found;
  warnings.push_back(fmt::format("link {}: a shape without volume is left out", link.name));
  return std::nullopt;
}

/// `Element` is a Collision or a Visual.
template <typename Element>
std::optional<RobotPart> to_part(const Element& element, const urdf::Link& link,
                                 const LinkFrames& frames, const MeshFinder& finder,
                                 std::vector<std::string>& warnings) {
  if (!element || !element->geometry) return std::nullopt;
  std::optional<FoundShape> found = to_shape(*element->geometry, link, finder, warnings);
  if (!found) return std::nullopt;
  RobotPart part{link.name, std::move(found->shape),
                 frames.at(link.name) * to_transform(element->origin), std::nullopt};
  if (!found->problem.empty()) warnings.push_back(found->problem);
  if (found->stand_in) {
    const Eigen::Isometry3d T_link_inertia =
        link.inertial ? to_transform(link.inertial->origin) : Eigen::Isometry3d::Identity();
    part.T_base_part = frames.at(link.name) * T_link_inertia;
  }
  return part;
}

}  // namespace

Eigen::Isometry3d to_transform(const urdf::Pose& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const urdf::Rotation& q = pose.rotation;
  T.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  T.translation() = to_vector(pose.position);
  return T;
}

LinkFrames link_frames(const urdf::ModelInterface& model, const JointPositions& positions) {
  LinkFrames frames{{model.getRoot()->name, Eigen::Isometry3d::Identity()}};
  std::vector<urdf::LinkConstSharedPtr> open{model.getRoot()};
  while (!open.empty()) {
    const urdf::LinkConstSharedPtr link = open.back();
    open.pop_back();
    for (const auto& joint : link->child_joints) {
      Eigen::Isometry3d& T_root_child = frames[joint->child_link_name];
      T_root_child = frames.at(link->name) * to_transform(joint->parent_to_joint_origin_transform);
      const auto moved = positions.find(joint->name);
      if (moved != positions.end())
        T_root_child = T_root_child * joint_motion(*joint, moved->second);
      open.push_back(model.getLink(joint->child_link_name));
    }
  }
  return frames;
}

std::vector<RobotPart> collision_parts(const urdf::Link& link, const LinkFrames& frames,
                                       const MeshFinder& finder,
                                       std::vector<std::string>& warnings) {
  std::vector<RobotPart> parts;
  for (const auto& collision : link.collision_array) {
    if (auto part = to_part(collision, link, frames, finder, warnings)) parts.push_back(*part);
  }
  return parts;
}

std::vector<RobotPart> visual_parts(const urdf::Link& link, const LinkFrames& frames,
                                    const MeshFinder& finder, std::vector<std::string>& warnings) {
  std::vector<RobotPart> parts;
  for (const auto& visual : link.visual_array) {
    auto part = to_part(visual, link, frames, finder, warnings);
    if (!part) continue;
    const bool coloured = visual->material && visual->material->texture_filename.empty();
    if (coloured) {
      const urdf::Color& c = visual->material->color;
      part->color = Eigen::Vector3f(c.r, c.g, c.b);
    }
    parts.push_back(*part);
  }
  return parts;
}

}  // namespace castaway::sim
