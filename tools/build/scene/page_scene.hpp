/// What pages draw in three dimensions, as JSON.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/people/bodies/person.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// A world without people and robot. Frame map.
struct PageWorld {
  std::vector<sim::SceneItem> items;     ///< Without floor and roofs.
  std::vector<sim::SceneItem> roofs;     ///< Pages can hide them.
  Eigen::Vector3f floor_color;           ///< RGB in [0, 1].
  Eigen::Vector2d min_corner{0.0, 0.0};  ///< [m] Extent of the floor, at z = 0.
  Eigen::Vector2d max_corner{0.0, 0.0};  ///< [m]
  double top = 0.0;                      ///< [m] Top of the items.
};

/// What an object of the world looks like at first, and after each of its changes; without items it
/// is not there.
using PageStates = std::vector<std::vector<sim::SceneItem>>;

/// Everything.
struct PageScene {
  PageWorld world;                               ///< Without `changing`.
  std::vector<sim::SceneItem> robot;             ///< In base, with all joints at 0.
  std::vector<sim::PersonBody> people{};         ///< By number.
  std::map<std::string, PageStates> changing{};  ///< Objects that events change, by name.
};

inline constexpr std::size_t kLiveSceneBytes = 6'000'000;    ///< Limit in the page of a live run.
inline constexpr std::size_t kReportSceneBytes = 3'000'000;  ///< Limit in a report.

/// JSON of a scene:
///   extent     [x, y, x, y] [m] of the floor
///   top        [m]
///   floor      [r, g, b] in [0, 1]
///   world, roof, robot   meshes (`mesh_json`), in map and in base; roof: null without one
///   ghost      the robot again, thinned: pages draw it several times
///   person     `person_json`
///   changing   {name: [mesh or null, ...]}: `PageScene::changing`; absent if that is empty
///   thinned_m  size of the cubes to which meshes were thinned, so that the JSON has at most about
///              `most_bytes`; 0 if they were not
std::string page_scene_json(const PageScene& scene, std::size_t most_bytes);

}  // namespace castaway::testbed
