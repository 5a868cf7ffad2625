/// From libsdformat's tree to objects. Internal to sim/world/sdf: it shows libsdformat's types.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <sdf/sdf.hh>

#include "sim/world/sdf/resource_finder.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Gathers the collision bodies of worlds and models.
class SdfBodies {
 public:
  /// `path`: of the world, for errors. `finder` must outlive this.
  SdfBodies(const ResourceFinder& finder, std::string path)
      : finder_(finder), path_(std::move(path)) {}

  /// All models of a world. @throws std::runtime_error naming file and element.
  void add(const sdf::World& world);
  /// A model and those nested in it.
  void add(const sdf::Model& model, const Eigen::Isometry3d& T_map_parent,
           const std::string& prefix = "");

  /// What was left out, each kind once a model.
  [[nodiscard]] std::vector<std::string> warnings() const {
    return {warnings_.begin(), warnings_.end()};
  }
  [[nodiscard]] std::vector<WorldObject> take() { return std::move(objects_); }

 private:
  void add(const sdf::Link& link, const Eigen::Isometry3d& T_map_model, const std::string& name);
  std::optional<ObjectShape> shape_of(const sdf::Geometry& geometry, const std::string& name,
                                      const Eigen::Isometry3d& T_map_shape);
  ObjectShape mesh_of(const sdf::Mesh& mesh, const std::string& name);
  Eigen::Isometry3d resolved(const sdf::SemanticPose& pose, const std::string& name) const;
  [[noreturn]] void fail(const std::string& name, const std::string& why) const;
  double length(double value, const std::string& name) const;
  std::string unique(const std::string& name);

  const ResourceFinder& finder_;
  std::string path_;
  std::vector<WorldObject> objects_;
  std::set<std::string> names_;
  std::set<std::string> warnings_;
};

}  // namespace castaway::sim
