/// The floors of a world for the simulator.
#pragma once

#include <memory>

#include "localization/space/map3d/atlas.hpp"
#include "sim/map/level_plane.hpp"
#include "sim/world/world.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// The ground of an atlas; its grid must not be turned.
sim::LevelPlane to_level_plane(const localization::Atlas& atlas);

/// Surveys a world and its ground on which a robot of this height [m] can drive. Throws as
/// `survey_world`.
std::shared_ptr<const Map3d> survey_floors(const sim::WorldSpec& world, double height);

/// The floors of a map. Throws as `localization::Atlas`.
std::shared_ptr<const sim::LevelPlane> level_plane_of(const Map3d& map);

}  // namespace castaway::testbed
