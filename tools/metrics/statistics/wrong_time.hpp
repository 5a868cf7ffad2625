/// The longest time without a break in which something is wrong.
#pragma once

#include <algorithm>

#include "localization/geometry/stamp.hpp"

namespace castaway::testbed {

/// Takes scans in their order. A time begins with its first wrong scan and ends with its last one.
class WrongTime {
 public:
  void take(localization::Stamp stamp, bool wrong) {
    if (wrong && !was_wrong_) since_ = stamp;
    if (wrong) longest_ = std::max(longest_, stamp - since_);
    was_wrong_ = wrong;
  }
  /// [s] 0 if nothing was wrong, or single scans only.
  [[nodiscard]] double longest_s() const { return localization::seconds(longest_); }

 private:
  bool was_wrong_ = false;
  localization::Stamp since_{};
  localization::Stamp longest_{};
};

}  // namespace castaway::testbed
