/// Agreement of two successive scans with the odometry between them: detects a kidnap from a single
/// pair of scans, without the map.
#pragma once

#include <optional>

#include "localization/geometry/se2.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Parameters of comparing end points.
struct ScanAgreementConfig {
  double tolerance = 0.2;  ///< [m] Ranges agree within this plus `tolerance_share` of the range.
  double tolerance_share = 0.05;  ///< See `tolerance`.
  /// [rad] Points between beams farther apart than this are not compared.
  double widest_gap = 0.2;
  int least = 15;  ///< With fewer comparable points there is no result.
};

/// Returns the share of comparable end points that agree: those of each scan that lie on something
/// that the other scan saw; the rest lie where the other saw free space. Points hidden from the
/// other scan or outside of its view do not count, nor do beams that are not level (`BeamKind`).
/// `T_before_now` is odometry's step of base.
/// Returns nothing if too few points can be compared.
std::optional<double> scan_agreement(const ScanAgreementConfig& config, const ScanPoints& before,
                                     const ScanPoints& now, const SE2& T_before_now);

}  // namespace castaway::localization
