/// What a robot's lidar sees, and how likely a localizer's observation model finds each beam.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "localization/map/distance_field.hpp"
#include "localization/sensor/endpoint_model.hpp"
#include "localization/space/volume/volume.hpp"
#include "sim/scene/scene.hpp"
#include "tools/play/observation/map_window.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// A map with the distances that the observation model looks up.
struct CostMap {
  localization::OccupancyGrid grid;
  localization::DistanceField distances;
};

/// The cells on z = 0: occupied ones dark, unknown ones grey, free ones the bluer the likelier a
/// beam ends there.
sim::SceneItem cost_map_item(const CostMap& map, const localization::EndpointConfig& model,
                             const MapWindow& window);

/// A beam in map.
struct ObservedBeam {
  Eigen::Vector3f origin;   ///< [m] The lidar.
  Eigen::Vector3f end;      ///< [m]
  float likelihood = 0.0F;  ///< Of its end point, relative to one on a surface; in (0, 1].
};

/// One scan at a robot's true pose.
struct Observation {
  localization::EndpointConfig model;                  ///< Of one end point.
  std::optional<CostMap> planar;                       ///< None: a 3-D map.
  std::shared_ptr<const localization::Volume> volume;  ///< Null: a planar map.
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();  ///< Of the first lidar.
  std::vector<ObservedBeam> beams;     ///< Those that the localizer uses.
  std::vector<sim::SceneItem> robot;   ///< In base.
  std::vector<sim::SceneItem> people;  ///< In map.
  double robot_size = 0.4;             ///< [m] Diameter of its outline.
  std::vector<std::string> warnings;   ///< About robot and world.
};

/// Plays a scenario until `time_s` [s] and observes the next scan. With 0 the robot stands at its
/// start. The observation model and the beams are those of the scenario's first `mh_amcl`; the map
/// is a 3-D map if that one works on one, or if there are several floors or slopes. Throws
/// std::exception for a scenario that cannot be built, or if there is no scan.
Observation observe(const Scenario& scenario, const std::filesystem::path& base, double time_s);

}  // namespace castaway::testbed
