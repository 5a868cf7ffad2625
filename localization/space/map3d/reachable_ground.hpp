/// The part of the ground that a robot can reach: not roofs, and not the tops of furniture.
#pragma once

#include <optional>

#include "localization/space/map3d/elevation_map.hpp"

namespace castaway::localization {

/// Leaves only those surfaces drivable that are connected with the drivable surface nearest to
/// `start` [m], or without a start, or without one near it (1 m), the largest connected part.
/// Neighbouring cells are connected if they differ in height by at most `step`. [m]
void keep_reachable(ElevationMap& map, const std::optional<Eigen::Vector3d>& start, double step);

}  // namespace castaway::localization
