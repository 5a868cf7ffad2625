/// Cuts the ground into charts: parts with one surface in each cell.
#pragma once

#include <vector>

#include "localization/space/map3d/elevation_map.hpp"
#include "localization/space/map3d/ground_walk.hpp"

namespace castaway::localization {

/// A part of the ground.
struct Chart {
  std::vector<SurfaceAt> own;     ///< Surfaces that belong to it.
  std::vector<SurfaceAt> margin;  ///< Of other charts, connected with it; no cell has two in all.
};

/// Cuts the drivable surfaces. A chart is connected, on one level, and in each cell has one surface
/// at most. Neighbouring cells are connected if they differ in height by at most `step`; margins
/// reach `reach` cells over the edges of a chart. [m]
std::vector<Chart> cut_charts(const ElevationMap& map, float step, int reach);

}  // namespace castaway::localization
