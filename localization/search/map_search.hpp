/// Global search: a search of the whole map that can extend over several scans.
///
/// The search runs in slices, so that the cost per scan is bounded for maps of any size. Odometry
/// moves the places found to the current position of base.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/search/create.hpp"

namespace castaway::localization {

/// Thoroughness of a search.
enum class SearchDepth {
  kUsual,  ///< With all end points and with the far ones; the matcher's number of candidates each.
  kDeep,   ///< With the far end points, for `CreateConfig::deep_candidates` candidates.
};

/// One search with one scan. The matcher must outlive it.
class MapSearch {
 public:
  /// `T_odom_base` is the odometry at the scan.
  MapSearch(const CreateConfig& config, const CascadeMatcher& matcher, const ScanPoints& points,
            const SE2& T_odom_base, SearchDepth depth);

  /// Continues for about `tiles` tiles (`BranchAndBound::step`). Returns true when the search is
  /// complete.
  bool step(std::int64_t tiles);
  [[nodiscard]] SearchDepth depth() const { return depth_; }
  /// Candidates found so far, as poses of base at the time of the odometry `T_odom_base`.
  [[nodiscard]] std::vector<Candidate> candidates(const SE2& T_odom_base) const;

 private:
  struct Part {
    BranchAndBound search;
    std::size_t points = 0;
  };
  void add(const ScanPoints& points, int most);

  const CascadeMatcher* matcher_;
  SE2 T_odom_base_;
  SearchDepth depth_;
  std::vector<Part> parts_;
};

/// Searches the map scan by scan: first as usual, then deep if nothing fits well. Stores the search
/// in progress. The matcher must outlive it.
class PlaceSearch {
 public:
  /// `slice` is the number of tiles searched per scan.
  PlaceSearch(const CascadeMatcher& matcher, std::int64_t slice)
      : matcher_(matcher), slice_(slice) {}

  /// True if a search is in progress, or a deep one is due with the next scan.
  [[nodiscard]] bool is_pending() const { return search_.has_value() || deeper_; }
  /// Continues the search by a slice; starts one with this scan if none is in progress. Returns the
  /// places found, refined on this scan, once the search is complete. `T_odom_base` is the odometry
  /// at the scan.
  std::optional<std::vector<WeighedPlace>> step(const CreateContext& context,
                                                const ScanPoints& points, const SE2& T_odom_base);
  /// Drops the search in progress.
  void cancel();

 private:
  const CascadeMatcher& matcher_;
  std::int64_t slice_;
  std::optional<MapSearch> search_;
  bool deeper_ = false;  ///< The last search found nothing that fits well.
};

/// Searches the whole map at once, deep if nothing fits well. Returns the places found, refined.
std::vector<WeighedPlace> find_places(const CreateContext& context, const CascadeMatcher& matcher,
                                      const ScanPoints& points);

}  // namespace castaway::localization
