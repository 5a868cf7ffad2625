/// A scan to be matched with the cells of an `NdtMap`: as points, or as distributions of its own.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "localization/sensor/scan_points.hpp"

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

}  // namespace castaway::localization
