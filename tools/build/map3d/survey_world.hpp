/// Surveys worlds into 3-D maps.
#pragma once

#include "sim/world/world.hpp"
#include "tools/build/map3d/survey_map3d.hpp"

namespace castaway::testbed {

/// The 3-D map of a world, as a perfect survey would make it. Without a start, its ground is
/// reached from `WorldSpec::inside`. Throws as `sim::sample_surfaces` and
/// `localization::survey_ground`.
Map3d survey_world(const sim::WorldSpec& world, const Map3dOptions& options);

}  // namespace castaway::testbed
