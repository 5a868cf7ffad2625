/// The scan of a 3-D lidar as points in base: the level layer, and a selection of the others.
#pragma once

#include <optional>

#include "localization/geometry/transform_buffer.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Projects the layers of a scan into the frame of base at `reference`, as `project_scan` does, and
/// says of which kind each beam is: at most `max_beams` of the layer nearest to the lidar's plane,
/// `max_tilted` of the others, and `max_flat` that end on flat surfaces. A surface is flat where
/// the returns of neighbouring layers in one direction rise by less than 0.6 relative to base: I.
/// Bogoslavskyi, C. Stachniss, "Fast Range Image-Based Segmentation of Sparse 3D Laser Scans for
/// Online Operation", IROS 2016. Requires layers of as many beams as the scan.
std::optional<ScanPoints> project_layers(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                         Stamp reference, const BeamSelection& selection);

}  // namespace castaway::localization
