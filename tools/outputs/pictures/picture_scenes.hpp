/// Scenes for the pictures of a run.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/scene/scene.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Scene data besides the run's own. Any member may be empty.
struct PictureWorld {
  std::vector<sim::SceneItem> world;         ///< In map; if empty, no 3-D pictures are possible (a
                                             ///< recorded log).
  std::vector<sim::SceneItem> from_above{};  ///< The world without roofs; empty if it has none.
  std::vector<sim::SceneItem> robot;  ///< In base: `T_map_mesh` is the pose of the mesh in base.
  /// Current moving objects in map: people, doors.
  std::function<std::vector<sim::SceneItem>()> moving;
  /// Current height, roll and pitch of base: on ramps, or while it is carried. Null: flat on the
  /// floor.
  std::function<Eigen::Isometry3d()> T_footprint_base{};
  Eigen::Vector2d min_corner{0.0, 0.0};  ///< [m] Extent of the world.
  Eigen::Vector2d max_corner{0.0, 0.0};  ///< [m]
  double top = 0.0;                      ///< [m] Top of the world's objects, roofs excluded.
  /// Of a world of several floors: height of the lowest ground at a place, if any. [m]
  std::function<std::optional<double>(const Eigen::Vector2d& p_map)> lowest_ground{};
  double robot_radius = 0.2;  ///< [m] Radius of the outlines on the map.
  std::optional<RosMap> map;  ///< Nothing: no pictures from above.
};

/// Current pose of base in space for this planar pose.
Eigen::Isometry3d pose_in_space(const PictureWorld& world, const SE2& T_map_footprint);

/// The robot at a pose (nothing: its pose at the scan) and the scan's hits, seen from behind the
/// robot. Needs the truth.
sim::Scene chase_scene(const PictureWorld& world, const ScanRecord& record,
                       const std::optional<SE2>& T_map_base = std::nullopt);

/// The whole world with the robot and the hits, seen from the south.
sim::Scene overview_scene(const PictureWorld& world, const ScanRecord& record,
                          const std::optional<SE2>& T_map_base = std::nullopt);

/// Placement of a map in an image.
struct MapView {
  double aspect = 1.0;  ///< Width / height of the image.
  double below = 0.0;   ///< Share of the height that is reserved at the bottom for a caption.
};

/// Length [m] that the image's height covers if the map fills it as far as possible.
double map_height(const RosMap& map, const MapView& view);

/// The map (`map_item` of `world.map`) from above: an arrow and an outline for each localizer in
/// its colour, its particles in a shade of it for each population, the truth in black, people as
/// ellipses with a nose.
sim::Scene map_scene(const PictureWorld& world, const sim::SceneItem& map_item,
                     const ScanRecord& record, const MapView& view);

/// A map as coloured rectangles: white free, black occupied, grey unknown.
sim::SceneItem map_item(const RosMap& map);

/// End points [m] in map of the beams that hit something.
std::vector<Eigen::Vector3f> lidar_hits(const LaserScan& scan, const Eigen::Isometry3d& T_map_base);

}  // namespace castaway::testbed
