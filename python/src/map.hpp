/// `Map`: an occupancy grid as localizers know it.
#pragma once

#include <memory>
#include <optional>

#include <pybind11/pybind11.h>

#include "localization/map/distance_field.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/map_conversion.hpp"

namespace castaway::python {

/// A map with what is computed from it on request.
struct Map {
  explicit Map(testbed::RosMap ros) : map(std::move(ros)), grid(to_occupancy_grid(map)) {}

  testbed::RosMap map;
  localization::OccupancyGrid grid;
  std::optional<localization::DistanceField> distances;  ///< Nothing before it is asked for.
};

/// Shared by Python and by the arrays that view it.
using SharedMap = std::shared_ptr<Map>;

void bind_map(pybind11::module_& module);

}  // namespace castaway::python
