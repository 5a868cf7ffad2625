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
#include <vector>

#include <Eigen/Core>

#include "localization/sensor/endpoint_model.hpp"
#include "localization/sensor/scan_points.hpp"
#include "localization/space/ndt/ndt_map.hpp"

namespace castaway::localization {

/// What of a scan is matched at once.
struct NdtScanPart {
  Eigen::Vector3f p_base = Eigen::Vector3f::Zero();      ///< [m] Point, or mean of points.
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();  ///< [m^2] In base; zero for a point.
  float points = 1.0F;                                   ///< How many it stands for.
};

/// A scan in base.
struct NdtScan {
  std::vector<NdtScanPart> parts;
  bool points = true;  ///< No part has a covariance.
};

/// Each end point by itself. `planar`: z = 0.
NdtScan scan_of_points(const ScanPoints& points, bool planar);

/// The end points in cells with edges of `cell` [m], each cell one distribution or a few
/// (`fit_cell`).
///
/// T. Stoyanov, M. Magnusson, H. Andreasson, A. J. Lilienthal, "Fast and accurate scan registration
/// through minimization of the distance between compact 3D NDT representations", The International
/// Journal of Robotics Research 31 (2012).
NdtScan scan_of_distributions(const ScanPoints& points, double cell, bool planar);

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
