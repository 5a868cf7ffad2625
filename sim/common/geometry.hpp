/// Planar poses of the simulator, and its gravity.
#pragma once

#include <Eigen/Geometry>

namespace castaway::sim {

inline constexpr double kGravity = 9.81;  ///< [m/s^2]

/// A pose in the plane: of the robot's base (or any frame b) in map (or any frame a).
struct Pose2 {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad] Counter-clockwise.

  /// Position. [m]
  [[nodiscard]] Eigen::Vector2d position() const { return {x, y}; }
  bool operator==(const Pose2&) const = default;
};

/// A velocity of the robot's base, in base: x forward.
struct Twist2 {
  double v = 0.0;  ///< [m/s] Forward.
  double w = 0.0;  ///< [rad/s] Counter-clockwise.
};

/// Angle wrapped to [-pi, pi). [rad]
double wrap_angle(double angle);

/// Composition: `T_a_c = T_a_b * T_b_c`; the yaw is wrapped.
Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c);
/// Coordinates in a of a point given in b.
Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b);
/// `T_b_a` of `T_a_b`.
Pose2 inverse(const Pose2& T_a_b);

/// The pose after driving `way` [m] from the identity along a circle that turns the heading by
/// `turn` [rad].
Pose2 arc(double way, double turn);

/// The pose lifted to 3-D: z, roll and pitch are 0.
Eigen::Isometry3d to_isometry(const Pose2& T_a_b);
/// The pose projected to the plane: x, y and the heading of b's x axis.
Pose2 to_planar(const Eigen::Isometry3d& T_a_b);
/// Interpolation between two transforms: linear in position, slerp in rotation. What does not
/// depend on the fraction is computed once.
class Interpolation {
 public:
  Interpolation(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

  /// The transform a fraction of the way from `a` to `b`.
  [[nodiscard]] Eigen::Isometry3d at(double fraction) const;

 private:
  Eigen::Vector3d from_;
  Eigen::Vector3d way_;
  Eigen::Quaterniond q_a_;
  Eigen::Quaterniond q_b_;  ///< With the sign that gives the shorter rotation.
  double angle_ = 0.0;      ///< [rad] Between the quaternions; 0 if it is too small.
  double per_sine_ = 1.0;   ///< 1 / sine of the angle.
};

/// The interpolation at one fraction.
Eigen::Isometry3d interpolate(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                              double fraction);

}  // namespace castaway::sim
