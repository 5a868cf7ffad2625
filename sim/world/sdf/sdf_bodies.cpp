#include "sim/world/sdf/sdf_bodies.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/world/mesh.hpp"

namespace castaway::sim {
namespace {

constexpr std::size_t kMaxObjects = 20000;
constexpr double kMaxLength = 1e4;  // [m]

Eigen::Isometry3d to_isometry(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z();
  T.rotate(Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized());
  return T;
}

/// Of the first visual with a material of its own.
Eigen::Vector3f color_of(const sdf::Link& link) {
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    const sdf::Material* material = link.VisualByIndex(i)->Material();
    if (material == nullptr) continue;
    const ignition::math::Color& c = material->Diffuse();
    if (c.R() + c.G() + c.B() > 0.0F) return Eigen::Vector3f(c.R(), c.G(), c.B()).cwiseMin(1.0F);
  }
  return {0.7F, 0.7F, 0.7F};
}

/// The ground: level, facing up, at z = 0.
bool is_ground(const sdf::Plane& plane, const Eigen::Isometry3d& T_map_plane) {
  const ignition::math::Vector3d n = plane.Normal();
  const Eigen::Vector3d up = T_map_plane.linear() * Eigen::Vector3d(n.X(), n.Y(), n.Z());
  return up.z() > 0.999 && std::abs(T_map_plane.translation().z()) < 0.05;
}

const char* name_of(sdf::GeometryType type) {
  if (type == sdf::GeometryType::CAPSULE) return "a capsule";
  if (type == sdf::GeometryType::ELLIPSOID) return "an ellipsoid";
  if (type == sdf::GeometryType::HEIGHTMAP) return "a height map";
  return "no geometry";
}

}  // namespace

void SdfBodies::fail(const std::string& name, const std::string& why) const {
  throw std::runtime_error(fmt::format("{}: {}: {}", path_, name, why));
}

double SdfBodies::length(double value, const std::string& name) const {
  if (value > 0.0 && value <= kMaxLength) return value;
  fail(name, fmt::format("a length of {}; give metres above 0", value));
}

std::string SdfBodies::unique(const std::string& name) {
  std::string result = name;
  for (int i = 1; !names_.insert(result).second; ++i) result = fmt::format("{}-{}", name, i);
  return result;
}

Eigen::Isometry3d SdfBodies::resolved(const sdf::SemanticPose& pose,
                                      const std::string& name) const {
  ignition::math::Pose3d value;
  const sdf::Errors errors = pose.Resolve(value);
  if (!errors.empty()) fail(name, "its pose: " + errors.front().Message());
  if (!value.IsFinite()) fail(name, "its pose is not finite");
  return to_isometry(value);
}

void SdfBodies::add(const sdf::World& world) {
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
    add(*world.ModelByIndex(i), Eigen::Isometry3d::Identity());
  }
}

void SdfBodies::add(const sdf::Model& model, const Eigen::Isometry3d& T_map_parent,
                    const std::string& prefix) {
  const std::string name = prefix + model.Name();
  if (!model.Static() && prefix.empty()) {
    warnings_.insert(fmt::format("{} is not static: it stands where it is", name));
  }
  const Eigen::Isometry3d T_map_model = T_map_parent * resolved(model.SemanticPose(), name);
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    add(*model.LinkByIndex(i), T_map_model, name);
  }
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
    add(*model.ModelByIndex(i), T_map_model, name + "/");
  }
}

void SdfBodies::add(const sdf::Link& link, const Eigen::Isometry3d& T_map_model,
                    const std::string& name) {
  const Eigen::Isometry3d T_map_link = T_map_model * resolved(link.SemanticPose(), name);
  const Eigen::Vector3f color = color_of(link);
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    const sdf::Collision& collision = *link.CollisionByIndex(i);
    const std::string full = fmt::format("{}/{}/{}", name, link.Name(), collision.Name());
    WorldObject object;
    object.T_map_object = T_map_link * resolved(collision.SemanticPose(), full);
    const auto shape = shape_of(*collision.Geom(), full, object.T_map_object);
    if (!shape) continue;
    object.shape = *shape;
    object.name = unique(full);
    object.piece = name;
    object.color = color;
    objects_.push_back(std::move(object));
    if (objects_.size() > kMaxObjects) fail(name, "more than 20000 bodies in the world");
  }
}

std::optional<ObjectShape> SdfBodies::shape_of(const sdf::Geometry& geometry,
                                               const std::string& name,
                                               const Eigen::Isometry3d& T_map_shape) {
  if (const sdf::Box* box = geometry.BoxShape()) {
    const auto& size = box->Size();
    return BoxShape{{length(size.X(), name), length(size.Y(), name), length(size.Z(), name)}};
  }
  if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
    return CylinderShape{length(cylinder->Radius(), name), length(cylinder->Length(), name)};
  }
  if (const sdf::Sphere* sphere = geometry.SphereShape()) {
    return SphereShape{length(sphere->Radius(), name)};
  }
  if (const sdf::Mesh* mesh = geometry.MeshShape()) return mesh_of(*mesh, name);
  if (const sdf::Plane* plane = geometry.PlaneShape()) {
    if (is_ground(*plane, T_map_shape)) return std::nullopt;
    warnings_.insert(name + ": a plane that is not the ground is left out");
    return std::nullopt;
  }
  warnings_.insert(fmt::format("{}: {} is left out", name, name_of(geometry.Type())));
  return std::nullopt;
}

ObjectShape SdfBodies::mesh_of(const sdf::Mesh& mesh, const std::string& name) {
  if (!mesh.Submesh().empty()) {
    warnings_.insert(fmt::format("{}: its submesh '{}' is not taken apart: the whole mesh stands",
                                 name, mesh.Submesh()));
  }
  const auto& scale = mesh.Scale();
  if (!scale.IsFinite() || scale.X() * scale.Y() * scale.Z() == 0.0) {
    fail(name, "a mesh's scale must be finite and not 0");
  }
  MeshShape shape;
  shape.scale = {scale.X(), scale.Y(), scale.Z()};
  try {
    const bool has_file = std::filesystem::is_regular_file(mesh.FilePath());
    const std::filesystem::path from =
        std::filesystem::absolute(has_file ? mesh.FilePath() : path_).parent_path();
    shape.path = finder_.find(mesh.Uri(), from).string();
    (void)load_mesh(shape.path, shape.scale);
  } catch (const std::exception& error) {
    fail(name, error.what());
  }
  return shape;
}

}  // namespace castaway::sim
