/// A scene as plain data, independent of OpenGL. Frame map: z up, metres.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace castaway::sim {

/// A triangle mesh in its own frame.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;  ///< [m]
  std::vector<Eigen::Vector3f> normals;   ///< Unit; same length as vertices.
  std::vector<Eigen::Vector3f>
      colors;                          ///< RGB in [0, 1]; same length as vertices, or empty: white.
  std::vector<std::uint32_t> indices;  ///< Three a triangle, counter-clockwise from outside.
};

/// Ranges of instance numbers, by which label maps distinguish objects.
inline constexpr std::uint16_t kFloorInstance = 1;
inline constexpr std::uint16_t kRobotInstance = 2;
inline constexpr std::uint16_t kFirstObjectInstance = 10;     ///< + index of the world's object.
inline constexpr std::uint16_t kFirstPersonInstance = 60000;  ///< + number of the person.

/// A mesh placed in the scene.
struct SceneItem {
  TriangleMesh mesh;
  Eigen::Isometry3f T_map_mesh = Eigen::Isometry3f::Identity();
  Eigen::Vector3f color{1.0F, 1.0F, 1.0F};  ///< Multiplies the vertex colours.
  bool shaded = true;                       ///< False: its plain colour, without light.
  std::uint16_t instance = 0;               ///< Number in label maps; 0: none.
  bool casts_shadow = true;                 ///< False: light passes (floors, roofs).
};

/// Points drawn over the scene (lidar hits, particles), all of one colour.
struct ScenePoints {
  std::vector<Eigen::Vector3f> points;  ///< [m]
  Eigen::Vector3f color{1.0F, 0.0F, 0.0F};
  float size_px = 3.0F;
};

/// Line segments drawn over the scene: points 2k and 2k + 1.
struct SceneLines {
  std::vector<Eigen::Vector3f> points;
  Eigen::Vector3f color{0.0F, 0.0F, 0.0F};
  float width_px = 1.0F;
};

/// Where a picture is taken from.
struct Camera {
  Eigen::Vector3f eye{0.0F, -5.0F, 5.0F};    ///< [m]
  Eigen::Vector3f target{0.0F, 0.0F, 0.0F};  ///< [m]
  Eigen::Vector3f up{0.0F, 0.0F, 1.0F};
  float fov_y_deg = 50.0F;    ///< Perspective; ignored if `ortho_height` is set.
  float ortho_height = 0.0F;  ///< [m] Above 0: parallel projection of this height.
};

/// All that a picture shows.
struct Scene {
  std::vector<SceneItem> items;
  std::vector<ScenePoints> points;
  std::vector<SceneLines> lines;
  Camera camera;
  Eigen::Vector3f background{0.93F, 0.95F, 0.97F};
};

/// Axis-aligned in map, not tight for a rotated item. Empty if the mesh is.
Eigen::AlignedBox3f bounds_of(const SceneItem& item);

/// Bounds of all shaded items. Empty if there are none.
Eigen::AlignedBox3f lit_bounds(const Scene& scene);

/// Height of the highest item that casts a shadow (not a roof or floor); 0 without any. [m]
float standing_height(const std::vector<SceneItem>& items);

}  // namespace castaway::sim
