/// Time stamps.
#pragma once

#include <chrono>

namespace castaway::localization {

/// Time since the epoch of the run or of the log; never a wall clock.
using Stamp = std::chrono::nanoseconds;

/// A stamp in seconds.
inline double seconds(Stamp stamp) { return std::chrono::duration<double>(stamp).count(); }

/// The stamp of `s` seconds, rounded to the nearest nanosecond.
inline Stamp from_seconds(double s) {
  return std::chrono::round<Stamp>(std::chrono::duration<double>(s));
}

}  // namespace castaway::localization

namespace castaway {

using localization::from_seconds;
using localization::seconds;
using localization::Stamp;

}  // namespace castaway
