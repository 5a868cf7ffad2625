/// What the pictures of a run show, as scenes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/scene/scene.hpp"
#include "tools/formats/ros_map.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// What is there to be seen beside what a run tells. Anything may be missing.
struct PictureWorld {
  std::vector<sim::SceneItem> world;         ///< In map; none: no 3-D pictures (a recorded log).
  std::vector<sim::SceneItem> from_above{};  ///< The same without roofs; empty: there is none.
  std::vector<sim::SceneItem> robot;  ///< In base: `T_map_mesh` is the pose of the mesh in base.
  /// What moves, now, in map: people, doors.
  std::function<std::vector<sim::SceneItem>()> moving;
  /// Height, roll and pitch of base, now: on ramps, or as it is carried. None: flat on the floor.
  std::function<Eigen::Isometry3d()> T_footprint_base{};
  Eigen::Vector2d min_corner{0.0, 0.0};  ///< [m] Extent of the world.
  Eigen::Vector2d max_corner{0.0, 0.0};  ///< [m]
  double top = 0.0;                      ///< [m] Of what stands in it, roofs left out.
  double robot_radius = 0.2;             ///< [m] Of the outlines on the map.
  std::optional<RosMap> map;             ///< None: no pictures from above.
};

/// Where base is in space, now, if this is its planar pose.
Eigen::Isometry3d pose_in_space(const PictureWorld& world, const SE2& T_map_footprint);

/// The robot at a pose (nothing: where it was at the scan) and the scan's hits, from behind the
/// robot. Needs the truth.
sim::Scene chase_scene(const PictureWorld& world, const ScanRecord& record,
                       const std::optional<SE2>& T_map_base = std::nullopt);

/// The whole world with the same robot and hits, from the south.
sim::Scene overview_scene(const PictureWorld& world, const ScanRecord& record,
                          const std::optional<SE2>& T_map_base = std::nullopt);

/// How a map fills a picture.
struct MapView {
  double aspect = 1.0;  ///< Width / height of the picture.
  double below = 0.0;   ///< Share of its height, at the bottom, that is left to a caption.
};

/// What the picture's height shows of a map that fills it as far as it can. [m]
double map_height(const RosMap& map, const MapView& view);

/// The map (`map_item` of `world.map`) from above: particles in one colour a population, an arrow
/// and outline for each localizer in its colour, the truth in black, people as ellipses with a
/// nose.
sim::Scene map_scene(const PictureWorld& world, const sim::SceneItem& map_item,
                     const ScanRecord& record, const MapView& view);

/// A map as coloured rectangles: white free, black occupied, grey unknown.
sim::SceneItem map_item(const RosMap& map);

/// Ends of the beams that hit something, in map. [m]
std::vector<Eigen::Vector3f> lidar_hits(const LaserScan& scan, const Eigen::Isometry3d& T_map_base);

}  // namespace castaway::testbed
