/// Scene of the localizer's benchmarks: an office and a scan taken in it.
#pragma once

#include "localization/map/distance_field.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::testbed {

struct BenchSceneSpec {
  double width = 40.0;   ///< [m] Width of the office (`draw_office`); its cells are 5 cm.
  double height = 30.0;  ///< [m]
  int beams = 180;       ///< Over a full turn, with a maximum range of 40 m.
  double noise = 0.02;   ///< [m] Half-width of the uniform noise of every range.
  double blocked = 0.0;  ///< Share of the beams that end at people 1 m away.
};

/// An office, a pose in it with 0.5 m of free space around it, and the scan taken there.
struct BenchScene {
  localization::OccupancyGrid grid;
  localization::DistanceField distances;
  localization::SE2 T_map_base;
  localization::LaserScan scan;
  localization::ScanPoints points;  ///< The scan in base coordinates.
};

/// Deterministic for a specification. Beams that are not blocked do not depend on `blocked`.
BenchScene bench_scene(const BenchSceneSpec& spec = {});

}  // namespace castaway::testbed
