/// The map as background of a plot.
#pragma once

#include "sim/scene/image.hpp"
#include "tools/base/formats/ros_map.hpp"

namespace castaway::testbed {

/// Maximum length [px] of a backdrop's longer side, since a page shows no more.
inline constexpr int kMostBackdropPixels = 2000;

/// Draws the map in grey, row 0 at its upper edge. A pixel of a large map covers n x n cells, with
/// the smallest n that fits, and shows the darkest of them so that walls remain visible.
sim::Image map_backdrop(const RosMap& map);

}  // namespace castaway::testbed
