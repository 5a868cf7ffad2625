#include "sim/world/sdf/sdf_bodies.hpp"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/world/footprint.hpp"
#include "sim/world/mesh.hpp"
#include "sim/world/sdf/flat_names.hpp"

namespace castaway::sim {
namespace {

constexpr std::size_t kMaxObjects = 20000;
constexpr double kMaxLength = 1e4;  // [m]
constexpr double kLevel = 0.999;    // Least z component of a level plane's unit normal.

Eigen::Isometry3d to_isometry(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z();
  T.rotate(Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized());
  return T;
}

/// Colour of the first visual with a material of its own.
Eigen::Vector3f color_of(const sdf::Link& link) {
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    const sdf::Material* material = link.VisualByIndex(i)->Material();
    if (material == nullptr) continue;
    const ignition::math::Color& c = material->Diffuse();
    if (c.R() + c.G() + c.B() > 0.0F) return Eigen::Vector3f(c.R(), c.G(), c.B()).cwiseMin(1.0F);
  }
  return {0.7F, 0.7F, 0.7F};
}

/// Name of an unsupported geometry, for messages.
std::string name_of(const sdf::Geometry& geometry) {
  if (geometry.Type() == sdf::GeometryType::HEIGHTMAP) return "a height map";
  const sdf::ElementPtr element = geometry.Element();
  const sdf::ElementPtr kind = element ? element->GetFirstElement() : nullptr;
  return kind ? "the geometry <" + kind->GetName() + ">" : "an empty geometry";
}

/// Throws the reason why a piece cannot be read; the catcher knows the piece.
[[noreturn]] void fail(const std::string& why) { throw std::runtime_error(why); }

double length(double value) {
  if (value > 0.0 && value <= kMaxLength) return value;
  fail(fmt::format("it has a length of {} m: it must be above 0 and at most {:.0f} m", value,
                   kMaxLength));
}

Eigen::Isometry3d resolve_pose(const sdf::SemanticPose& pose) {
  ignition::math::Pose3d value;
  const sdf::Errors errors = pose.Resolve(value);
  if (!errors.empty()) fail("its pose cannot be resolved: " + errors.front().Message());
  if (!value.IsFinite()) fail("its pose is not finite");
  return to_isometry(value);
}

}  // namespace

const ClassicPlace* SdfBodies::place_of(const std::string& path) const {
  const auto place = state_.places.find(path);
  return place == state_.places.end() ? nullptr : &place->second;
}

void SdfBodies::leave_out(const std::string& name, const std::runtime_error& error) {
  if (policy_.strict) {
    throw std::runtime_error(fmt::format("{}: {}: {}", path_, name, error.what()));
  }
  policy_.notes->leave_out(name, error);
}

std::string SdfBodies::unique(const std::string& name) {
  std::string result = name;
  for (int i = 1; !names_.insert(result).second; ++i) result = fmt::format("{}-{}", name, i);
  return result;
}

void SdfBodies::add(const sdf::World& world) {
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
    add(*world.ModelByIndex(i), Eigen::Isometry3d::Identity());
  }
}

void SdfBodies::add(const sdf::Model& model, const Eigen::Isometry3d& T_map_parent,
                    const std::string& prefix) {
  const std::string name = prefix + unscoped_name(model.Name());
  if (prefix.empty()) models_.insert(name);
  if (state_.deletions.contains(name)) return;
  if (!model.Static() && prefix.empty()) {
    policy_.notes->add("not static, but treated as static", name);
  }
  Eigen::Isometry3d T_map_model;
  try {
    const ClassicPlace* place = place_of(name);
    T_map_model =
        place != nullptr ? place->T_world_body : T_map_parent * resolve_pose(model.SemanticPose());
  } catch (const std::runtime_error& error) {
    return leave_out(name, error);
  }
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    add(*model.LinkByIndex(i), T_map_model, name);
  }
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
    add(*model.ModelByIndex(i), T_map_model, name + "/");
  }
}

void SdfBodies::add(const sdf::Link& link, const Eigen::Isometry3d& T_map_model,
                    const std::string& name) {
  WorldObject object;
  object.piece = name;
  object.color = color_of(link);
  const std::string path = name + "/" + unscoped_name(link.Name());
  if (link.CollisionCount() == 0 && link.VisualCount() > 0) {
    policy_.notes->count_unread("links with visuals only", path);
  }
  const ClassicPlace* place = place_of(path);
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    const sdf::Collision& collision = *link.CollisionByIndex(i);
    object.name = fmt::format("{}/{}", path, collision.Name());
    try {
      add(collision,
          place != nullptr ? place->T_world_body : T_map_model * resolve_pose(link.SemanticPose()),
          object);
    } catch (const std::runtime_error& error) {
      leave_out(object.name, error);
    }
    if (objects_.size() > kMaxObjects) {
      throw std::length_error(
          fmt::format("{}: {}: more than {} bodies in the world", path_, name, kMaxObjects));
    }
  }
}

void SdfBodies::add(const sdf::Collision& collision, const Eigen::Isometry3d& T_map_link,
                    WorldObject object) {
  object.T_map_object = T_map_link * resolve_pose(collision.SemanticPose());
  const auto shape = shape_of(*collision.Geom(), object.name, object.T_map_object);
  if (!shape) return;
  object.shape = *shape;
  if (const ClassicPlace* place = place_of(object.piece)) {
    object.shape = scale_classic(object.shape, place->scale);
    (void)length(bounds(object).sizes().maxCoeff());
  }
  object.name = unique(object.name);
  objects_.push_back(std::move(object));
}

std::optional<ObjectShape> SdfBodies::shape_of(const sdf::Geometry& geometry,
                                               const std::string& name,
                                               const Eigen::Isometry3d& T_map_shape) {
  if (const sdf::Box* box = geometry.BoxShape()) {
    const auto& size = box->Size();
    return BoxShape{{length(size.X()), length(size.Y()), length(size.Z())}};
  }
  if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
    return CylinderShape{length(cylinder->Radius()), length(cylinder->Length())};
  }
  if (const sdf::Sphere* sphere = geometry.SphereShape()) {
    return SphereShape{length(sphere->Radius())};
  }
  if (const sdf::Mesh* mesh = geometry.MeshShape()) return mesh_of(*mesh, name);
  if (const sdf::Plane* plane = geometry.PlaneShape()) {
    add_plane(*plane, T_map_shape);
    return std::nullopt;
  }
  return shape_around(geometry, name);
}

/// The simplest supported shape around an unsupported one.
std::optional<ObjectShape> SdfBodies::shape_around(const sdf::Geometry& geometry,
                                                   const std::string& name) {
  if (const sdf::Capsule* capsule = geometry.CapsuleShape()) {
    policy_.notes->add("a capsule is replaced by the cylinder around it", name);
    const double radius = length(capsule->Radius());
    return CylinderShape{radius, length(capsule->Length()) + 2.0 * radius};
  }
  if (const sdf::Ellipsoid* ellipsoid = geometry.EllipsoidShape()) {
    policy_.notes->add("an ellipsoid is replaced by the box around it", name);
    const auto& r = ellipsoid->Radii();
    return BoxShape{{2.0 * length(r.X()), 2.0 * length(r.Y()), 2.0 * length(r.Z())}};
  }
  fail(fmt::format("{} is not supported", name_of(geometry)));
}

void SdfBodies::add_plane(const sdf::Plane& plane, const Eigen::Isometry3d& T_map_plane) {
  const ignition::math::Vector3d n = plane.Normal();
  const Eigen::Vector3d up = T_map_plane.linear() * Eigen::Vector3d(n.X(), n.Y(), n.Z());
  if (up.z() <= kLevel) fail("a plane that is not level is not supported");
  const Eigen::Vector3d p = T_map_plane.translation();
  if (ground_ && ground_->height <= p.z()) return;
  ground_ = Ground{p.z(), {}};
  if (plane.Size() == sdf::Plane().Size()) return;  // Without a given size, the plane is infinite.
  const Eigen::Vector2d half(0.5 * length(plane.Size().X()), 0.5 * length(plane.Size().Y()));
  ground_->extent = Eigen::AlignedBox2d(p.head<2>() - half, p.head<2>() + half);
}

/// Checks a mesh; one that many models share is read once.
void SdfBodies::require_readable(const std::string& path) {
  const auto [entry, is_new] = meshes_.try_emplace(path);
  if (is_new) {
    try {
      (void)load_mesh(path, Eigen::Vector3d::Ones());
    } catch (const std::exception& error) {
      entry->second = error.what();
    }
  }
  if (!entry->second.empty()) fail(entry->second);
}

ObjectShape SdfBodies::mesh_of(const sdf::Mesh& mesh, const std::string& name) {
  if (!mesh.Submesh().empty()) {
    policy_.notes->add("submeshes are not supported, the whole mesh is used", name);
  }
  const auto& scale = mesh.Scale();
  if (!scale.IsFinite() || scale.X() * scale.Y() * scale.Z() == 0.0) {
    fail("a mesh's scale must be finite and not 0");
  }
  const bool has_file = std::filesystem::is_regular_file(mesh.FilePath());
  const std::filesystem::path from =
      std::filesystem::absolute(has_file ? mesh.FilePath() : path_).parent_path();
  MeshShape shape;
  shape.scale = {scale.X(), scale.Y(), scale.Z()};
  shape.path = finder_.find(mesh.Uri(), from).string();
  require_readable(shape.path);
  return shape;
}

}  // namespace castaway::sim
