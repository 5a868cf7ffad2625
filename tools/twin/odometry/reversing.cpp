#include "tools/twin/odometry/reversing.hpp"

#include <cmath>

namespace castaway::testbed {
namespace {

constexpr double kClear = 0.03;  // [m] Alignments are more accurate.

double along_of(const Leg& leg) {
  double along = 0.0;
  for (const OdometryStep& step : leg.steps) along += step.along;
  return along;
}

/// True if the robot drives so far, and so straight, that the sign of its motion is clear.
bool is_clear(const Leg& leg) {
  constexpr double kBend = 0.5;  // [rad]
  return !leg.breaks && std::abs(leg.T_start_end.yaw) < kBend &&
         std::abs(leg.T_start_end.x) > kClear && std::abs(along_of(leg)) > kClear;
}

bool disagrees(const Leg& leg) { return is_clear(leg) && leg.T_start_end.x * along_of(leg) < 0.0; }

}  // namespace

bool is_distance_unsigned(const std::vector<Leg>& legs) {
  constexpr int kFewest = 10;
  int reversing = 0;
  int ahead = 0;
  for (const Leg& leg : legs) {
    if (!is_clear(leg) || leg.T_start_end.x > 0.0) continue;
    ++reversing;
    if (along_of(leg) > 0.0) ++ahead;
  }
  return ahead >= kFewest && 2 * ahead > reversing;
}

std::vector<Leg> sign_distances(std::vector<Leg> legs) {
  for (Leg& leg : legs) {
    if (!disagrees(leg)) continue;
    for (OdometryStep& step : leg.steps) {
      step.along = -step.along;
      step.across = -step.across;
    }
  }
  return legs;
}

}  // namespace castaway::testbed
