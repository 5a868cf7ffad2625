/// Random errors of odometry and of the alignment, as variance components.
#pragma once

#include <vector>

#include "tools/twin/odometry/stretch.hpp"

namespace castaway::testbed {

/// Variances that add up to that of a miss. The starting values are those of a usual robot.
struct OdometryNoise {
  double along_per_m = 4e-4;  ///< [m^2/m] Random walk along the heading.
  double yaw_per_m = 4e-4;    ///< [rad^2/m] Random walk of the yaw by travel,
  double yaw_per_rad = 4e-4;  ///< [rad^2/rad] and by turn.
  double match = 2e-4;        ///< [m^2] Of an aligned pose, in each direction.
  double match_yaw = 4e-5;    ///< [rad^2]
  double stamp = 1e-4;        ///< [s^2] Of a scan's stamp.

  /// Variances of a miss along, across and in yaw. [m^2], [m^2], [rad^2]
  [[nodiscard]] Eigen::Vector3d variances(const Stretch& stretch) const;
};

/// What the random walk of the yaw grows with.
enum class YawWalk { kTravelAndTurn, kTravel, kTurn };

/// Fits the variances to the misses by iterated weighted least squares of their squares, which is
/// maximum likelihood for normal misses. Outliers are left out. `start`: where to begin.
OdometryNoise fit_noise(const std::vector<const std::vector<Stretch>*>& sets,
                        const DriveErrors& errors, const OdometryNoise& start, YawWalk walk);

/// The simplest walk that explains the yaws, by Schwarz's criterion (G. Schwarz, "Estimating the
/// dimension of a model", Annals of Statistics 6, 1978). `start`: the noise fitted with both.
YawWalk choose_walk(const std::vector<const std::vector<Stretch>*>& sets, const DriveErrors& errors,
                    const OdometryNoise& start);

}  // namespace castaway::testbed
