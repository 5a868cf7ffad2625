/// The localizer's steps written directly from the formulas, without optimisation: particles as an
/// array of structures, double throughout, sine and cosine at every beam, map lookups in metres.
/// They are the reference of the benchmarks and an oracle for tests.
#pragma once

#include <vector>

#include "localization/map/distance_field.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/paper/ray_local_model.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::testbed {

/// A particle: pose of base in map.
struct PlainParticle {
  double x = 0.0;           ///< [m]
  double y = 0.0;           ///< [m]
  double yaw = 0.0;         ///< [rad]
  double log_weight = 0.0;  ///< Not normalised.
};

/// A scan of a lidar at the origin of base.
struct PlainScan {
  std::vector<double> range;  ///< [m]
  std::vector<double> angle;  ///< [rad] In the base frame.
};

/// The valid beams of a scan whose lidar is at the origin of base.
PlainScan plain_scan(const localization::LaserScan& scan);

/// Same as `predict` with `OdometryMotion`.
void plain_predict(std::vector<PlainParticle>& particles, const localization::SE2& u,
                   const localization::OdometryNoiseConfig& noise, localization::Rng& rng);

/// Same as `EndpointModel::log_likelihood`, but with nearest-cell lookup instead of interpolation
/// between four cells.
double plain_endpoints(const localization::EndpointConfig& config,
                       const localization::DistanceField& distances, const PlainScan& scan,
                       const PlainParticle& at);

/// Same as `RayLocalModel::evaluate`.
localization::RayLocalScore plain_rays(const localization::RayLocalConfig& config,
                                       const localization::OccupancyGrid& grid,
                                       const PlainScan& scan, const PlainParticle& at);

/// Same as `EvidenceModel::evaluate`, but with nearest-cell lookup and rays followed in steps of
/// half a cell.
double plain_evidence(const localization::EvidenceConfig& config,
                      const localization::OccupancyGrid& grid,
                      const localization::DistanceField& distances, const PlainScan& scan,
                      const PlainParticle& at);

localization::SE2 plain_mean(const std::vector<PlainParticle>& particles);

/// Draws as many particles by weight, each by a linear search from the first particle, and adds
/// Gaussian noise.
std::vector<PlainParticle> plain_reseed(const std::vector<PlainParticle>& particles, double sigma_m,
                                        double sigma_rad, localization::Rng& rng);

}  // namespace castaway::testbed
