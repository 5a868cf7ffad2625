/// Observation model on the cells of a normal distributions transform: the log-likelihood of a scan
/// with its derivatives by the pose.
///
/// Point to distribution: M. Magnusson, "The Three-Dimensional Normal-Distributions Transform",
/// PhD thesis, Orebro University (2009), section 6.2; distribution to distribution: T. Stoyanov et
/// al. (`scan_of_distributions`). Differences: only the nearest distribution counts, and the
/// likelihood of an end point is that of `EndpointConfig`, with the Mahalanobis distance in place
/// of the distance: `exp(-m^2 / 2) + floor`, where sigma^2 is added to the covariances.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "localization/sensor/endpoint_model.hpp"
#include "localization/space/ndt/ndt_map.hpp"
#include "localization/space/ndt/ndt_scan.hpp"

namespace castaway::localization {

/// Log-likelihood of a scan, and how it changes with x, y [m] and yaw [rad].
struct NdtFit {
  double log_likelihood = 0.0;  ///< 0 is perfect.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  /// Negative curvature as Gauss and Newton have it: never negative.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// Evaluates scans against one map.
class NdtModel {
 public:
  /// The map, and the volume that it was made of, must outlive the model. Poses are in map, with a
  /// volume in its atlas: where it has no ground, all beams are far from any surface.
  NdtModel(const EndpointConfig& config, const NdtMap& map, const Volume* volume = nullptr);

  [[nodiscard]] bool is_planar() const { return map_.is_planar(); }
  [[nodiscard]] NdtFit fit(const NdtScan& scan, const SE2& T_map_base) const;

 private:
  /// The pose of base in space, and how it moves with x, y and yaw.
  struct Stance {
    Eigen::Matrix3f R;        ///< From base to map.
    Eigen::Vector3f t;        ///< [m]
    Eigen::Vector3f along_x;  ///< Of t, per metre.
    Eigen::Vector3f along_y;
    Eigen::Vector3f axis;  ///< Of the yaw.
  };
  [[nodiscard]] std::optional<Stance> stand(const SE2& T_map_base) const;
  void add(const Stance& stance, const NdtScanPart& part, bool is_point, NdtFit& sum) const;

  EndpointConfig config_;
  const NdtMap& map_;
  const Volume* volume_;
};

}  // namespace castaway::localization
