/// A planar map as localizers see it, as a mesh.
#pragma once

#include "localization/map/distance_field.hpp"
#include "localization/sensor/endpoint_model.hpp"
#include "sim/scene/scene.hpp"
#include "tools/play/observation/map_window.hpp"

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

}  // namespace castaway::testbed
