/// A world as plain data. Frame map: z up, the floor is z = 0.
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

/// The corners of a box in its frame. [m]
inline std::vector<Eigen::Vector3d> box_corners(const BoxShape& box) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                               (i & 4) != 0 ? 0.5 : -0.5);
    corners.emplace_back(sign.cwiseProduct(box.size));
  }
  return corners;
}

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

/// A triangle mesh, loaded by assimp; concave shapes are kept.
struct MeshShape {
  std::string path;  ///< Absolute path of the file.
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// The shape of a static object.
using ObjectShape = std::variant<BoxShape, CylinderShape, MeshShape, SphereShape, RampShape>;

/// Optical properties of a surface.
struct Surface {
  double reflectivity = 0.6;  ///< Diffuse, at the lidar's wavelength, [0, 1]; black cloth 0.05.
  bool glass = false;  ///< Light passes, except for the share that the lidar's profile reflects.
};

/// One static object of a world.
struct WorldObject {
  std::string name;  ///< Unique within the world; used in errors.
  ObjectShape shape;
  Eigen::Isometry3d T_map_object = Eigen::Isometry3d::Identity();
  Eigen::Vector3f color{0.7F, 0.7F, 0.7F};  ///< RGB in [0, 1].
  bool in_map = true;                       ///< False: in the world, but not on the map.
  Surface surface{};
  bool in_world = true;   ///< False: on the map, but no longer in the world.
  bool movable = false;   ///< Furniture: the difference layer may move or remove it.
  bool drivable = false;  ///< To be driven over (ramps, sills): no obstacle for planners.
  /// Common to the bodies of one piece of furniture, which move as one; empty: a single body.
  std::string piece{};
};

/// A door leaf on hinges. Its bodies in world and map, or a single one if they agree, are objects
/// of the world.
struct Door {
  std::string name;  ///< Unique; the leaf's body in the world is called `name/leaf`.
  /// At the floor under the hinge, x along the closed leaf.
  Eigen::Isometry3d T_map_hinge = Eigen::Isometry3d::Identity();
  Eigen::Vector3d leaf{1.0, 0.04, 2.0};  ///< [m] Width, thickness, height.
  double turn = 1.0;                     ///< Direction of opening about z: +1 or -1.
  double open_deg = 0.0;                 ///< [deg] Opening angle in the world.
};

/// A part of the floor on which wheels turn farther than the robot moves.
struct SlipZone {
  std::string name;
  std::vector<Eigen::Vector2d> outline;  ///< [m] A simple polygon in map.
  double slip = 0.2;  ///< Mean share of the wheels' distance that is lost, [0, 1).
};

/// A world.
struct WorldSpec {
  std::string name;
  std::vector<WorldObject> objects;
  Eigen::Vector2d min_corner{0.0, 0.0};  ///< [m] Extent of the floor and of the rasterised map.
  Eigen::Vector2d max_corner{0.0, 0.0};  ///< [m]
  std::vector<SlipZone> slip_zones;
  std::vector<Door> doors;
  bool levels = false;                    ///< Robots drive on all floors; false: on the lowest one.
  std::optional<Eigen::Vector2d> inside;  ///< [m] A point in the area that is surveyed.
};

}  // namespace castaway::sim
