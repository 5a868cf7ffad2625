/// The time in which something is wrong: in total, and the longest without a break.
#pragma once

#include <algorithm>

#include "castaway/stamp.hpp"

namespace castaway::testbed {

/// Takes scans in their order. Each scan counts until the next one, the last one until the end.
class WrongTime {
 public:
  void take(localization::Stamp stamp, bool wrong) {
    const localization::Stamp lasted = was_wrong_ ? stamp - newest_ : localization::Stamp::zero();
    stretch_ = was_wrong_ ? stretch_ + lasted : lasted;
    total_ += lasted;
    longest_ = std::max(longest_, stretch_);
    was_wrong_ = wrong;
    newest_ = stamp;
  }
  /// Ends the series; an end before the last scan counts as the stamp of that scan.
  void finish(localization::Stamp end) { take(std::max(end, newest_), false); }

  /// [s] Until the newest scan, or until the end.
  [[nodiscard]] double total_s() const { return localization::seconds(total_); }
  /// [s] As `total_s`.
  [[nodiscard]] double longest_s() const { return localization::seconds(longest_); }

 private:
  bool was_wrong_ = false;
  localization::Stamp newest_{};
  localization::Stamp stretch_{};
  localization::Stamp total_{};
  localization::Stamp longest_{};
};

}  // namespace castaway::testbed
