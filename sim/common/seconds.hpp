/// Conversion between seconds and nanoseconds.
#pragma once

#include <chrono>
#include <cmath>

namespace castaway::sim {

/// A time in seconds, rounded to nanoseconds.
inline std::chrono::nanoseconds to_nanoseconds(double seconds) {
  return std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

/// [s]
inline double to_seconds(std::chrono::nanoseconds t) {
  return std::chrono::duration<double>(t).count();
}

}  // namespace castaway::sim
