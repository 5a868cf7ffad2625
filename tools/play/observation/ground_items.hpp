/// A 3-D map as localizers see it, as meshes: the elevation map, and what stands on it.
#pragma once

#include "localization/sensor/endpoint_model.hpp"
#include "localization/space/volume/volume.hpp"
#include "sim/scene/scene.hpp"
#include "tools/play/observation/map_window.hpp"

namespace castaway::testbed {

/// The ground of a 3-D map with its contour lines, every 0.5 m.
struct GroundItems {
  sim::SceneItem surface;
  sim::SceneLines contours;
};

/// The ground up to the next floor, light where it is high; the bluer the likelier a beam ends on
/// an obstacle `height` [m] above it, and blue where it is not drivable.
GroundItems ground_items(const localization::Volume& volume,
                         const localization::EndpointConfig& model, const MapWindow& window,
                         double height);

/// The voxels that are not drivable ground, as small cubes at their mean surface points; without
/// those buried in the ground and those of the next floor.
sim::SceneItem obstacles_item(const localization::Volume& volume, const MapWindow& window);

}  // namespace castaway::testbed
