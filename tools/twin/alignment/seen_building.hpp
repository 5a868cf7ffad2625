/// The building as a log saw it: its map with what stands elsewhere.
#pragma once

#include "tools/base/formats/ros_map.hpp"
#include "tools/twin/alignment/aligned_log.hpp"

namespace castaway::testbed {

/// The map of a log as its scans saw it, in cells of at most 25 mm where the map is small enough: a
/// cell is occupied if more scans saw a return from it than saw through it, and a wall of the map
/// stays unless more than twice as many saw through it. Walls are where they
/// reflect, things that stand are added, and walls that most scans saw through are gone. Close to
/// walls (`kCloseToWall`) and where the map does not know, one scan is enough; elsewhere people
/// walk, and two scans must agree. Places that no scan saw are those of the map, which must be that
/// of the log.
RosMap see_building(const RosMap& map, const AlignedLog& log);

inline constexpr double kCloseToWall = 0.25;  // [m]

}  // namespace castaway::testbed
