/// The robot's messages as castaway::localization takes them: SI units, REP-103 axes, REP-117
/// ranges.
#pragma once

#include <castaway/readings.hpp>

#include "messages.hpp"

castaway::Odometry to_odometry(const WheelMessage& message);
castaway::LaserScan to_scan(const SweepMessage& message);
