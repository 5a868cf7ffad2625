/// Searches the map scan by scan: first as usual, then deeper where nothing fits well.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/hypotheses/map_search.hpp"

namespace castaway::localization {

/// Keeps the search that is going on. The matcher outlives it.
class PlaceSearch {
 public:
  /// `slice`: tiles searched with one scan.
  PlaceSearch(const CascadeMatcher& matcher, std::int64_t slice)
      : matcher_(matcher), slice_(slice) {}

  /// Whether a search goes on, or a deeper one is due with the next scan.
  [[nodiscard]] bool is_pending() const { return search_.has_value() || deeper_; }
  /// Goes on by a slice, beginning with this scan where none goes on. The places found, refined on
  /// this scan, once the search is complete. `T_odom_base`: odometry at the scan.
  std::optional<std::vector<WeighedPlace>> step(const CreateContext& context,
                                                const ScanPoints& points, const SE2& T_odom_base);
  /// Forgets the search that goes on.
  void cancel();

 private:
  const CascadeMatcher& matcher_;
  std::int64_t slice_;
  std::optional<MapSearch> search_;
  bool deeper_ = false;  ///< The last search found nothing that fits well.
};

}  // namespace castaway::localization
