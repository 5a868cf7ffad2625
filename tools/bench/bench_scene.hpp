/// What the benchmarks of the localizer work on: an office and a scan taken in it.
#pragma once

#include "localization/map/distance_field.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::testbed {

/// Which scene.
struct BenchSceneSpec {
  double width = 40.0;   ///< [m] Of the office (`draw_office`), cells of 5 cm.
  double height = 30.0;  ///< [m]
  int beams = 180;       ///< Over a full turn, up to 40 m.
  double noise = 0.02;   ///< [m] Uniform, of every range.
  double blocked = 0.0;  ///< Share of the beams that end at people 1 m away.
};

/// An office, a pose in it with half a metre around it free, and the scan from there.
struct BenchScene {
  localization::OccupancyGrid grid;
  localization::DistanceField distances;
  localization::SE2 T_map_base;
  localization::LaserScan scan;
  localization::ScanPoints points;  ///< The scan in base coordinates.
};

/// Always the same for one specification. The fewer beams are blocked, the more are as before.
BenchScene bench_scene(const BenchSceneSpec& spec = {});

}  // namespace castaway::testbed
