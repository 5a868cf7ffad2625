/// Short steps of odometry, and their correction by systematic errors.
#pragma once

#include <vector>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// Systematic errors of odometry, for any differential drive. All zero: none.
struct OdometryErrors {
  double scale = 0.0;      ///< True distance = (1 + scale) * measured distance.
  double yaw_scale = 0.0;  ///< True turn = (1 + yaw_scale) * measured turn + curvature * distance.
  double curvature = 0.0;  ///< [rad/m]
  double swing = 0.0;      ///< [m/rad] Distance that a measured turn adds.
};

/// The errors of a drive whose wheels' true radii and measured ones differ by `scale` in the mean
/// and by `curvature` between the sides. `track` [m] is the distance between the wheels.
OdometryErrors errors_of(double scale, double yaw_scale, double curvature, double track);

/// What the motion of a base by odometry errs by systematically.
struct DriveErrors {
  OdometryErrors odometry;
  /// Pose of odometry's frame in base, which the stated mount of the lidar defines: where the
  /// wheels turn about, and where they roll to. The identity if the mount is stated correctly.
  localization::SE2 T_base_drive;
};

/// A short step of odometry as a twist: a constant velocity over the unit of time.
struct OdometryStep {
  double along = 0.0;   ///< [m]
  double across = 0.0;  ///< [m]
  double turn = 0.0;    ///< [rad]
  double way = 0.0;     ///< [m] Mean travel of the wheels.
};

/// The step `u = T_base0_base1` of a robot with this distance between its wheels [m].
OdometryStep step_of(const localization::SE2& u, double track);

/// The motion that corrected odometry states for some steps.
localization::SE2 correct_motion(const std::vector<OdometryStep>& steps,
                                 const OdometryErrors& errors);
/// The motion of base.
localization::SE2 correct_base_motion(const std::vector<OdometryStep>& steps,
                                      const DriveErrors& errors);

}  // namespace castaway::testbed
