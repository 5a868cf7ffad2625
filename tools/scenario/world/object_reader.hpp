/// Helpers and readers of world objects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/world.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Bodies that may not have names yet, and the doors among them.
struct Bodies {
  std::vector<sim::WorldObject> bodies;
  std::vector<sim::Door> doors;
  bool named = false;  ///< True if the bodies already have names.
};

/// Value of `key` in metres, greater than 0 and at most 1 km.
double positive(YamlReader& reader, const std::string& key, double fallback);
double required_positive(YamlReader& reader, const std::string& key);
/// Three edges `size`, each greater than 0 and at most 1 km.
Eigen::Vector3d size_of(YamlReader& reader);

/// Frame of an object on the floor: x and y from `at`, rotated by `yaw_deg`, with z of its
/// underside from `bottom`.
Eigen::Isometry3d floor_frame(YamlReader& reader);
/// A frame translated by `by`, given in its own coordinates.
Eigen::Isometry3d translate(const Eigen::Isometry3d& T, const Eigen::Vector3d& by);
/// An unnamed body.
sim::WorldObject body(sim::ObjectShape shape, const Eigen::Isometry3d& T_map_object);
/// A box whose underside is centred at `p` of a frame.
sim::WorldObject box_at(const Eigen::Isometry3d& T, const Eigen::Vector3d& p,
                        const Eigen::Vector3d& size);

/// Readers by kind; meshes are searched in `folder`.
Bodies read_box(YamlReader& reader);
Bodies read_step(YamlReader& reader);
Bodies read_ramp(YamlReader& reader);
Bodies read_cylinder(YamlReader& reader);
Bodies read_sphere(YamlReader& reader);
Bodies read_mesh(YamlReader& reader, const std::filesystem::path& folder);
Bodies read_table(YamlReader& reader);
Bodies read_chair(YamlReader& reader);
Bodies read_shelf(YamlReader& reader);
Bodies read_wall(YamlReader& reader);
Bodies read_glass(YamlReader& reader);
Bodies read_window(YamlReader& reader);
Bodies read_door(YamlReader& reader);

}  // namespace castaway::testbed
