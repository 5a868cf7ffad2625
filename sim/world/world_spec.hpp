/// A world as plain data: what stands where. Frame map: z up, the floor is z = 0.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace castaway::sim {

/// A cuboid centred on its frame.
struct BoxShape {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m] Full edge lengths.
};

/// An upright cylinder (axis z) centred on its frame.
struct CylinderShape {
  double radius = 0.5;  ///< [m]
  double height = 1.0;  ///< [m]
};

/// A ball centred on its frame.
struct SphereShape {
  double radius = 0.5;  ///< [m]
};

/// A wedge: its upper face rises along x, from the lower edge at -size.x / 2 to the full height at
/// +size.x / 2; centred on its frame.
struct RampShape {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< [m] Length along x, width, height.
};

/// A triangle mesh, loaded through assimp, static geometry: concave shapes are kept as they are.
struct MeshShape {
  std::string path;  ///< Absolute path of the file.
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// The shape of a static object.
using ObjectShape = std::variant<BoxShape, CylinderShape, MeshShape, SphereShape, RampShape>;

/// What a lidar's light meets.
struct Surface {
  double reflectivity = 0.6;  ///< Diffuse, at the lidar's wavelength, [0, 1]; black cloth 0.05.
  bool glass = false;         ///< Light passes, but for what the lidar's profile says comes back.
};

/// One static object of a world.
struct WorldObject {
  std::string name;  ///< Unique within the world; names it in errors.
  ObjectShape shape;
  Eigen::Isometry3d T_map_object = Eigen::Isometry3d::Identity();
  Eigen::Vector3f color{0.7F, 0.7F, 0.7F};  ///< RGB in [0, 1].
  bool in_map = true;                       ///< False: stands in the world, but not on the map.
  Surface surface{};
  bool in_world = true;   ///< False: on the map, but no longer in the world.
  bool movable = false;   ///< Furniture: the difference layer may move it or take it away.
  bool drivable = false;  ///< Meant to be driven over (ramps, sills): no obstacle for planners.
  /// Bodies of one piece of furniture share it and move as one; empty: stands alone.
  std::string piece{};
};

/// A leaf on hinges. Its two bodies, or one where map and world agree, are objects of the world.
struct Door {
  std::string name;  ///< Unique; the leaf's body in the world is called `name/leaf`.
  /// At the floor under the hinge, x along the closed leaf.
  Eigen::Isometry3d T_map_hinge = Eigen::Isometry3d::Identity();
  Eigen::Vector3d leaf{1.0, 0.04, 2.0};  ///< [m] Width, thickness, height.
  double turn = 1.0;                     ///< Sense of opening about z: +1 or -1.
  double open_deg = 0.0;                 ///< [deg] How far it stands open in the world.
};

/// A part of the floor on which wheels turn further than the robot moves.
struct SlipZone {
  std::string name;
  std::vector<Eigen::Vector2d> outline;  ///< [m] A simple polygon in map.
  double slip = 0.2;  ///< Share of the wheels' way that is lost on average, [0, 1).
};

/// A world.
struct WorldSpec {
  std::string name;
  std::vector<WorldObject> objects;
  Eigen::Vector2d min_corner{0.0, 0.0};  ///< [m] Extent of the floor and of the rasterised map.
  Eigen::Vector2d max_corner{0.0, 0.0};  ///< [m]
  std::vector<SlipZone> slip_zones;
  std::vector<Door> doors;
  std::optional<Eigen::Vector2d> inside;  ///< [m] A point of the floor that is surveyed.
};

}  // namespace castaway::sim
