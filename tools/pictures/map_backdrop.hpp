/// The map behind a plot's paths.
#pragma once

#include "sim/scene/image.hpp"
#include "tools/formats/ros_map.hpp"

namespace castaway::testbed {

/// Pixels of a backdrop's longer side, at most: a page shows no more.
inline constexpr int kMostBackdropPixels = 2000;

/// The map in greys, row 0 its upper edge. A pixel of a larger map stands for n x n cells, n as
/// small as fits, and shows the darkest of them, so that no wall is lost.
sim::Image map_backdrop(const RosMap& map);

}  // namespace castaway::testbed
