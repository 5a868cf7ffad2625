/// What a localizer uses outside of castaway's thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

namespace castaway::testbed {

/// Use of other processes or threads, since the start of the run.
struct OutsideUse {
  std::chrono::nanoseconds cpu{};
  double peak_memory_mb = 0.0;  ///< [MB] Largest resident set; 0: not known.
  /// Of the conversation, such as scans "answered" and "missing".
  std::map<std::string, std::int64_t> counts{};
};

}  // namespace castaway::testbed
