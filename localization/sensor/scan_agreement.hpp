/// Whether two scans in a row and the odometry between them agree: a cue of a kidnap in a single
/// frame that does not depend on the map.
#pragma once

#include <optional>

#include "localization/geometry/se2.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// How end points are compared.
struct ScanAgreementConfig {
  double tolerance = 0.2;         ///< [m] Ranges so close agree...
  double tolerance_share = 0.05;  ///< ...or within this share of the range, added to it.
  double widest_gap = 0.2;        ///< [rad] Between beams farther apart nothing is known.
  int least = 15;                 ///< Fewer points that can be compared say nothing.
};

/// Of the end points of each scan that the other could see, the share that lie on something that it
/// saw; the rest lie where it looked through. Points hidden from it, or outside of its view, do not
/// count. `T_before_now` is odometry's step of base. Nothing where too few points can be compared.
std::optional<double> scan_agreement(const ScanAgreementConfig& config, const ScanPoints& before,
                                     const ScanPoints& now, const SE2& T_before_now);

}  // namespace castaway::localization
