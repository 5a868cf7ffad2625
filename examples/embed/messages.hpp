/// What this robot's drivers send: their own units and conventions, as drivers have them.
#pragma once

#include <vector>

/// Dead reckoning of the wheels since they were switched on.
struct WheelMessage {
  double time_s = 0.0;
  double forward_m = 0.0;    ///< Position along the robot's first heading...
  double left_m = 0.0;       ///< ...and to the left of it.
  double heading_deg = 0.0;  ///< Counter-clockwise from it.
};

/// One turn of the lidar, which sits `kLidarAhead` before the middle of the wheels.
struct SweepMessage {
  double time_s = 0.0;            ///< Of the first distance.
  std::vector<int> distances_mm;  ///< One a degree, counter-clockwise from behind; 0: no echo.
};

inline constexpr double kLidarAhead = 0.1;   ///< [m]
inline constexpr double kLidarRange = 8.0;   ///< [m]
inline constexpr double kSweepPeriod = 0.1;  ///< [s]
