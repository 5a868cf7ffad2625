/// The steps of the localizer written straight from the formulas, without any thought of speed:
/// particles as an array of structures, double throughout, sine and cosine at every beam, the map
/// looked up in metres. What the benchmarks compare with, and an oracle for tests.
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

/// A scan of a lidar in the centre of base.
struct PlainScan {
  std::vector<double> range;  ///< [m]
  std::vector<double> angle;  ///< [rad] In base.
};

/// The valid beams of a scan whose lidar stands in the centre of base.
PlainScan plain_scan(const localization::LaserScan& scan);

/// As `predict` with `OdometryMotion`.
void plain_predict(std::vector<PlainParticle>& particles, const localization::SE2& u,
                   const localization::OdometryNoiseConfig& noise, localization::Rng& rng);

/// As `EndpointModel::log_likelihood`, but at the nearest cell instead of between four.
double plain_endpoints(const localization::EndpointConfig& config,
                       const localization::DistanceField& distances, const PlainScan& scan,
                       const PlainParticle& at);

/// As `RayLocalModel::evaluate`.
localization::RayLocalScore plain_rays(const localization::RayLocalConfig& config,
                                       const localization::OccupancyGrid& grid,
                                       const PlainScan& scan, const PlainParticle& at);

/// As `EvidenceModel::evaluate`, at the nearest cells, following rays in steps of half a cell.
double plain_evidence(const localization::EvidenceConfig& config,
                      const localization::OccupancyGrid& grid,
                      const localization::DistanceField& distances, const PlainScan& scan,
                      const PlainParticle& at);

/// Weighted mean.
localization::SE2 plain_mean(const std::vector<PlainParticle>& particles);

/// As many particles drawn by weight, each from the start of the list, spread by Gaussian noise.
std::vector<PlainParticle> plain_reseed(const std::vector<PlainParticle>& particles, double sigma_m,
                                        double sigma_rad, localization::Rng& rng);

}  // namespace castaway::testbed
