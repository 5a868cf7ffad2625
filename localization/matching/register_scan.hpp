/// Registers a scan with a normal distributions transform: climbs to the maximum of the likelihood
/// by damped Gauss-Newton steps. Where `refine_pose` tries poses, this follows the derivatives.
///
/// K. Levenberg, "A Method for the Solution of Certain Non-Linear Problems in Least Squares",
/// Quarterly of Applied Mathematics 2 (1944), with Marquardt's scaling (1963).
#pragma once

#include <optional>

#include "localization/matching/refine.hpp"
#include "localization/space/ndt/ndt_model.hpp"

namespace castaway::localization {

/// A pose where a scan fits best.
struct Registration {
  SE2 T_map_base;
  NdtFit fit;  ///< Of the scan alone.
};

/// Returns the pose near `start` with the highest score: log-likelihood of the scan minus half the
/// squared Mahalanobis distance from the prior. A flat score returns the start.
Registration register_scan(const NdtModel& model, const NdtScan& scan, const SE2& start,
                           const std::optional<PosePrior>& prior = {});

/// How scans are matched with the cells.
enum class NdtMatching {
  kPoints,         ///< Point to distribution.
  kDistributions,  ///< Distribution to distribution.
};

/// Registers scans with one map.
struct NdtRegistration {
  NdtModel model;
  NdtMatching matching = NdtMatching::kPoints;
  double cell = 0.5;  ///< [m] Of a scan's distributions.

  [[nodiscard]] NdtScan scan_of(const ScanPoints& points) const;
  [[nodiscard]] Registration register_points(const ScanPoints& points, const SE2& start,
                                             const std::optional<PosePrior>& prior = {}) const {
    return register_scan(model, scan_of(points), start, prior);
  }
  [[nodiscard]] NdtFit fit(const ScanPoints& points, const SE2& T_map_base) const {
    return model.fit(scan_of(points), T_map_base);
  }
};

}  // namespace castaway::localization
