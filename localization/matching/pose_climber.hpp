/// Climbs to the pose where a scan fits best, and measures the curvature there: by hill climbing on
/// a likelihood of end points, or by registration with a normal distributions transform.
#pragma once

#include <optional>

#include "localization/matching/refine.hpp"
#include "localization/matching/register_scan.hpp"

namespace castaway::localization {

/// A view of models, which must outlive it.
struct PoseClimber {
  const EndpointModel& model;
  const NdtRegistration* ndt = nullptr;  ///< Null: hill climbing on `model`.

  /// The pose near `start` with the highest score (`refine_pose`, `register_scan`); `config` is
  /// that of hill climbing.
  [[nodiscard]] SE2 climb(const ScanPoints& points, const SE2& start,
                          const std::optional<PosePrior>& prior, const RefineConfig& config) const;
  /// The same pose with what the scan alone says there.
  struct Summit {
    SE2 T_map_base;
    double log_likelihood = 0.0;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  };
  [[nodiscard]] Summit summit(const ScanPoints& points, const SE2& start, const PosePrior& prior,
                              const RefineConfig& config) const;
  /// Of the scan alone, from a pose. [nats]
  [[nodiscard]] double log_likelihood(const ScanPoints& points, const SE2& T_map_base) const;
  /// Information (inverse covariance) about the pose from the scan alone.
  [[nodiscard]] Eigen::Matrix3d information(const ScanPoints& points, const SE2& T_map_base) const;
};

}  // namespace castaway::localization
