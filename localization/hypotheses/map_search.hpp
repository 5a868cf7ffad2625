/// A search of the whole map that may go on over several scans.
///
/// The cost of one scan stays bounded however large the map is: the search goes on in slices, and
/// odometry carries what it has found to where base is by then.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/hypotheses/create.hpp"

namespace castaway::localization {

/// How thoroughly the map is searched.
enum class SearchDepth {
  kUsual,  ///< By all end points and by the far ones, for the matcher's number of candidates each.
  kDeep,   ///< By the far end points, for `CreateConfig::deep_candidates`.
};

/// One search of one scan. The matcher outlives it.
class MapSearch {
 public:
  /// `T_odom_base` is odometry at the scan.
  MapSearch(const CreateConfig& config, const CascadeMatcher& matcher, const ScanPoints& points,
            const SE2& T_odom_base, SearchDepth depth);

  /// Goes on for about `tiles` tiles (`BranchAndBound::step`); true when the search is complete.
  bool step(std::int64_t tiles);
  [[nodiscard]] SearchDepth depth() const { return depth_; }
  /// What was found, as poses of base now, when odometry is at `T_odom_base`.
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

/// Searches scan by scan, first as usual, then deeper where nothing fits well: keeps the search
/// that is going on. The matcher outlives it.
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

/// Searches the whole map in one go, deeper where nothing fits well: the places found, refined.
std::vector<WeighedPlace> find_places(const CreateContext& context, const CascadeMatcher& matcher,
                                      const ScanPoints& points);

}  // namespace castaway::localization
