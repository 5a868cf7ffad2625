/// What the readers of world objects share.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/world/world_spec.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Bodies as yet without names, and the doors among them.
struct Bodies {
  std::vector<sim::WorldObject> bodies;
  std::vector<sim::Door> doors;
  bool named = false;  ///< True: the bodies have names already.
};

/// The value of `key` in metres, above 0 and at most 1 km.
double positive(YamlReader& reader, const std::string& key, double fallback);
double required_positive(YamlReader& reader, const std::string& key);
/// Three edges `size`, each above 0 and at most 1 km.
Eigen::Vector3d size_of(YamlReader& reader);

/// The frame of an object on the floor: x and y from `at`, turned by `yaw_deg`, z at its underside,
/// `bottom`.
Eigen::Isometry3d floor_frame(YamlReader& reader);
/// A frame moved by `by`, in its own coordinates.
Eigen::Isometry3d shifted(const Eigen::Isometry3d& T, const Eigen::Vector3d& by);
/// A body without a name.
sim::WorldObject body(sim::ObjectShape shape, const Eigen::Isometry3d& T_map_object);
/// A box whose underside is centred on `p` of a frame.
sim::WorldObject box_at(const Eigen::Isometry3d& T, const Eigen::Vector3d& p,
                        const Eigen::Vector3d& size);

/// Readers by kind; `folder` is where meshes are looked for.
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
