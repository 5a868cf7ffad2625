/// Least squares of odometry's errors over the stretches of a drive.
#pragma once

#include <vector>

#include "tools/twin/odometry/odometry_noise.hpp"

namespace castaway::testbed {

/// The stretches of a drive, of two lengths: brief ones tell the error of the alignment, far ones
/// the errors of odometry.
struct Stretches {
  std::vector<Stretch> brief;
  std::vector<Stretch> far;
};

/// Systematic and random errors.
struct DriveFit {
  DriveErrors errors;
  OdometryNoise noise;
};

/// Fits both in turn: systematic errors to the far stretches by Huber-weighted least squares,
/// random ones to all. `track` [m] is the distance between the wheels.
DriveFit fit_drive(const Stretches& stretches, double track,
                   YawWalk walk = YawWalk::kTravelAndTurn);

}  // namespace castaway::testbed
