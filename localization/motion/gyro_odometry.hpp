/// Odometry whose turns are measured by a gyro: wheels of a skid steer slide sideways in every
/// turn.
///
/// J. Borenstein, L. Feng, "Gyrodometry: A New Method for Combining Data from Gyros and Odometry in
/// Mobile Robots", ICRA 1996. Difference: the gyro counts whenever the wheels turn, not only where
/// both disagree.
#pragma once

#include <deque>
#include <optional>

#include "castaway/stamp.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Replaces the turns of odometry. Without readings of a gyro it changes nothing.
class GyroOdometry {
 public:
  /// Takes the mean rate of turn about z of base since the reading before, or for 0.1 s. [rad/s]
  /// Rates that are not finite, and those of a time before, are dropped.
  void add(Stamp stamp, double rate);
  /// Takes a reading of odometry; returns it with the turns of the gyro. A reading of a time before
  /// changes nothing, and is returned as it is. While the wheels rest, so does the result; while
  /// the gyro is silent, the turns are those of odometry.
  SE2 take(Stamp stamp, const SE2& T_odom_base);
  /// Begins anew.
  void clear() { *this = {}; }

 private:
  /// Sum of the turns up to a time.
  struct Heading {
    Stamp stamp{};
    double yaw = 0.0;  ///< [rad] Not wrapped.
  };
  /// A reading of odometry, and what became of it.
  struct Pose {
    Stamp stamp{};
    SE2 T_odom_base;
    SE2 T_fused_base;
    std::optional<double> yaw;  ///< [rad] Of the gyro; nothing if it was silent.
  };
  [[nodiscard]] std::optional<double> yaw_at(Stamp stamp) const;
  /// The fused pose after a reading of odometry, at the gyro's `yaw`.
  static SE2 step(const Pose& from, const SE2& T_odom_base, const std::optional<double>& yaw);

  std::deque<Heading> headings_;
  double rate_ = 0.0;  ///< [rad/s] The newest.
  std::optional<Pose> last_;
};

}  // namespace castaway::localization
