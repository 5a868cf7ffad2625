/// Fits the surfaces of walls, and the place of the lidar that makes them sharpest, to a log.
#pragma once

#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// Where the walls of the map reflect the beams of an aligned log. `usual` [m]: where they do
/// without measurements.
WallOffsets learn_walls(const AlignedLog& log, double usual);

/// Variance of the walls' surfaces, about the mean of each cell, if all aligned poses are moved by
/// `T_base_moved`. [m^2]
double wall_variance(const AlignedLog& log, const SE2& T_base_moved);

/// True for a lidar with walls on all sides, which tell its place: one that sees at least 270
/// degrees. The place of another is confused with the surfaces of the walls that it looks at.
bool looks_around(const AlignedLog& log);

/// Moves the aligned poses to the place, seen from the robot, where the walls are sharpest, by at
/// most 3 cm along each axis. A lidar that looks ahead fits as well if it is farther ahead and the
/// walls are farther behind the borders of their cells, but then a wall that is seen from two
/// directions has two surfaces.
void sharpen_walls(AlignedLog& log);

}  // namespace castaway::testbed
