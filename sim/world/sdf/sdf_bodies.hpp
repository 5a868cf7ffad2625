/// Converts libsdformat's tree to objects. Internal to sim/world/sdf: it exposes libsdformat's
/// types.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sdf/sdf.hh>

#include "sim/world/floor.hpp"
#include "sim/world/sdf/resource_finder.hpp"
#include "sim/world/sdf/world_pieces.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Collects the collision bodies of worlds and models.
class SdfBodies {
 public:
  /// `path`: of the world, for errors. `finder` must outlive this.
  /// `state`: where Gazebo classic puts models and links; it must outlive this, too.
  SdfBodies(const ResourceFinder& finder, std::string path, const PiecePolicy& policy,
            const ClassicState& state)
      : finder_(finder), path_(std::move(path)), policy_(policy), state_(state) {}

  /// Adds all models of a world. @throws std::runtime_error naming file and element if there are
  /// too many, or if the policy is strict and one cannot be read.
  void add(const sdf::World& world);
  /// Adds a model and its nested models.
  void add(const sdf::Model& model, const Eigen::Isometry3d& T_map_parent,
           const std::string& prefix = "");

  /// The lowest level plane that faces up.
  [[nodiscard]] const std::optional<Ground>& ground() const { return ground_; }
  [[nodiscard]] std::vector<WorldObject> take() { return std::move(objects_); }
  /// Names of the world's own models that were met so far.
  [[nodiscard]] const std::set<std::string>& models() const { return models_; }

 private:
  void add(const sdf::Link& link, const Eigen::Isometry3d& T_map_model, const std::string& name);
  void add(const sdf::Collision& collision, const Eigen::Isometry3d& T_map_link,
           WorldObject object);
  std::optional<ObjectShape> shape_of(const sdf::Geometry& geometry, const std::string& name,
                                      const Eigen::Isometry3d& T_map_shape);
  std::optional<ObjectShape> shape_around(const sdf::Geometry& geometry, const std::string& name);
  void add_plane(const sdf::Plane& plane, const Eigen::Isometry3d& T_map_plane);
  ObjectShape mesh_of(const sdf::Mesh& mesh, const std::string& name);
  void require_readable(const std::string& path);
  void leave_out(const std::string& name, const std::runtime_error& error);
  std::string unique(const std::string& name);

  [[nodiscard]] const ClassicPlace* place_of(const std::string& path) const;

  const ResourceFinder& finder_;
  std::string path_;
  std::vector<WorldObject> objects_;
  std::set<std::string> names_;
  std::set<std::string> models_;
  PiecePolicy policy_;
  const ClassicState& state_;
  std::optional<Ground> ground_;
  /// By path: why a mesh cannot be read; empty if it can.
  std::map<std::string, std::string> meshes_;
};

}  // namespace castaway::sim
