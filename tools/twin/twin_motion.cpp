#include "tools/twin/twin_motion.hpp"

#include <cmath>

namespace castaway::testbed {

TwinMotion motion_of(const AlignedLog& log) {
  TwinMotion motion;
  double product = 0.0;
  double square = 0.0;
  double turned = 0.0;
  for (const Leg& leg : take_legs(log, kTwinTrack)) {
    for (const OdometryStep& step : leg.steps) {
      product += step.across * step.turn;
      square += step.turn * step.turn;
      turned += std::abs(step.turn);
    }
  }
  constexpr double kFewestTurns = 3.0;  // [rad]
  if (turned > kFewestTurns) motion.axle_m = product / square;
  motion.duration_s = seconds(log.scans.back().scan.stamp - log.scans.front().scan.stamp);
  return motion;
}

SE2 axle_in_base(const FittedLog& fitted) {
  const auto& odometry = fitted.fit.odometry;
  const SE2 T_base_drive = odometry ? odometry->errors.T_base_drive : SE2{};
  return T_base_drive * SE2{-motion_of(fitted.log).axle_m, 0.0, 0.0};
}

}  // namespace castaway::testbed
