/// The nearest surface of a 3-D map along lines.
#pragma once

#include "localization/geometry/four_floats.hpp"
#include "localization/space/volume/surface_field.hpp"

namespace castaway::localization {

/// How far the nearest surface is from four points [m, in map] along lines with these directions
/// (unit vectors), ahead or back: at most `reach`. [m]
///
/// Sphere tracing (`voxel_rays`) until a surface is near, then on to its plane.
FourFloats surface_along(const SurfaceField& surfaces, const FourPoints& from,
                         const FourPoints& direction, float reach);

}  // namespace castaway::localization
