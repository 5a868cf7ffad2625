/// What a localizer uses outside of castaway's thread.
#pragma once

#include <chrono>

namespace castaway::testbed {

/// Use of other processes or threads, since the start of the run.
struct OutsideUse {
  std::chrono::nanoseconds cpu{};
  double peak_memory_mb = 0.0;  ///< [MB] Largest resident set.
};

}  // namespace castaway::testbed
