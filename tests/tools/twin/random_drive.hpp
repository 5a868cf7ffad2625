/// Synthetic legs of a drive with errors that are applied by hand, for tests of fits.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>

#include "localization/geometry/random.hpp"
#include "tools/twin/alignment/motion_samples.hpp"

namespace castaway::testbed {

inline constexpr double kRandomTrack = 0.4;  // [m]

/// A drive and its errors. Speeds vary, and parts that are straight follow curves to both sides.
struct RandomDrive {
  int legs = 8000;              ///< Of 0.2 s.
  double slowest = 0.2;         ///< [m/s]
  double fastest = 1.2;         ///< [m/s]
  double bend = 2.0;            ///< [rad/m] In curves, at most.
  DriveErrors errors{};         ///< Systematic.
  double along = 0.0;           ///< [m/sqrt(m)]
  double yaw_by_travel = 0.0;   ///< [rad/sqrt(m)]
  double yaw_by_turn = 0.0;     ///< [rad/sqrt(rad)]
  double match = 0.0;           ///< [m] Of an aligned pose.
  double match_yaw = 0.0;       ///< [rad]
  double stamp = 0.0;           ///< [s] Of a scan's stamp.
  double slips_per_m = 0.0;     ///< [1/m] Of each wheel; both within a leg do not occur.
  double slip_excess_m = 0.03;  ///< [m] That the wheel turns too far.
  int number = 1;               ///< Of the random stream.
};

/// The legs of a drive.
inline std::vector<Leg> legs_of(const RandomDrive& drive) {
  constexpr double kPeriod = 0.2;  // [s]
  localization::Rng rng = localization::substream(drive.number, "random drive");
  localization::Rng slip_rng = localization::substream(drive.number, "random slips");
  boost::random::normal_distribution<double> normal;
  const auto draw = [&](double sigma) { return sigma * normal(rng); };
  const auto speed_at = [&](int k) {
    const double middle = 0.5 * (drive.slowest + drive.fastest);
    return middle + 0.5 * (drive.fastest - drive.slowest) * std::sin(0.043 * k);
  };
  const auto bend_at = [&](int k) {
    return k / 60 % 2 == 0 ? 0.0 : drive.bend * std::sin(0.13 * k);
  };
  const auto state_at = [&](SE2 T_map_drive, const OdometryRate& rate) {
    const double late = draw(drive.stamp);
    T_map_drive =
        T_map_drive * correct_motion({{late * rate.along, 0.0, late * rate.turn, 0.0}}, {});
    const double x = draw(drive.match);
    const double y = draw(drive.match);
    return T_map_drive * drive.errors.T_base_drive.inverse() * SE2{x, y, draw(drive.match_yaw)};
  };
  std::vector<Leg> legs;
  SE2 T_map_drive;
  OdometryRate rate{speed_at(0), speed_at(0) * bend_at(0)};
  SE2 T_map_start = state_at(T_map_drive, rate);
  const OdometryErrors& errors = drive.errors.odometry;
  for (int k = 0; k < drive.legs; ++k) {
    const OdometryRate next{speed_at(k + 1), speed_at(k + 1) * bend_at(k + 1)};
    const double along = 0.5 * kPeriod * (rate.along + next.along);
    const double turn = along * bend_at(k);
    const double way = std::max(std::abs(along), 0.5 * kRandomTrack * std::abs(turn));
    const double true_along =
        (1.0 + errors.scale) * along + errors.swing * turn + draw(drive.along * std::sqrt(way));
    const double by_turn = draw(drive.yaw_by_turn * std::sqrt(std::abs(turn)));
    const double true_turn = (1.0 + errors.yaw_scale) * turn + errors.curvature * along + by_turn +
                             draw(drive.yaw_by_travel * std::sqrt(way));
    T_map_drive = T_map_drive * correct_motion({{true_along, 0.0, true_turn, 0.0}}, {});
    const SE2 T_map_end = state_at(T_map_drive, next);
    Leg leg;
    leg.steps.push_back({along, 0.0, turn, way});
    const double slip = boost::random::uniform_01<double>()(slip_rng);
    if (slip < 2.0 * drive.slips_per_m * way) {
      const bool is_left = slip < drive.slips_per_m * way;
      leg.steps[0].along += 0.5 * drive.slip_excess_m;
      leg.steps[0].turn += (is_left ? -1.0 : 1.0) * drive.slip_excess_m / kRandomTrack;
    }
    leg.T_start_end = T_map_start.inverse() * T_map_end;
    leg.way = way;
    leg.rate_at_start = rate;
    leg.rate_at_end = next;
    legs.push_back(leg);
    T_map_start = T_map_end;
    rate = next;
  }
  return legs;
}

inline void expect_errors(const OdometryErrors& fitted, const OdometryErrors& truth,
                          double tolerance) {
  EXPECT_NEAR(fitted.scale, truth.scale, tolerance);
  EXPECT_NEAR(fitted.yaw_scale, truth.yaw_scale, tolerance);
  EXPECT_NEAR(fitted.curvature, truth.curvature, tolerance);
}

}  // namespace castaway::testbed
