/// Global search: a search of the whole map that can extend over several scans.
///
/// The search runs in slices, so that the cost per scan is bounded for maps of any size. Odometry
/// moves the places found to the current position of base.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/search/create.hpp"
#include "localization/search/work_budget.hpp"

namespace castaway::localization {

/// Thoroughness of a search.
enum class SearchDepth {
  kQuick,  ///< With all end points, for `CreateConfig::quick_candidates` candidates.
  kDeep,   ///< With the far end points, for `CreateConfig::deep_candidates` candidates.
};

/// One search with one scan. The matcher must outlive it.
class MapSearch {
 public:
  /// `T_odom_base` is the odometry at the scan.
  MapSearch(const CreateConfig& config, const PlaceMatcher& matcher, const ScanPoints& points,
            const SE2& T_odom_base, SearchDepth depth);
  /// Searches with all end points for at most `most` candidates with a score of at least `least`.
  MapSearch(const PlaceMatcher& matcher, const ScanPoints& points, const SE2& T_odom_base, int most,
            double least);

  /// Continues for about `tiles` tiles (`BranchAndBound::step`), or as many as `budget` grants, and
  /// spends them. Returns true when the search is complete.
  bool step(std::int64_t tiles, WorkBudget& budget);
  /// Candidates found so far, as poses of base at the time of the odometry `T_odom_base`.
  [[nodiscard]] std::vector<Candidate> candidates(const SE2& T_odom_base) const;
  /// Maximum number of candidates.
  [[nodiscard]] int most() const { return most_; }
  /// Estimate of the work of `refine_found` for `most` of them. [tiles]
  [[nodiscard]] std::int64_t tiles_to_refine(int most) const;

 private:
  const PlaceMatcher* matcher_;
  int most_ = 0;
  SE2 T_odom_base_;
  std::optional<StagedSearch> search_;  ///< None for a scan without points.
};

/// Searches the map scan by scan: quickly at first, then deep if the result is unclear, and deep
/// from then on until a result is clear. Stores the search in progress. The matcher must outlive
/// it.
class PlaceSearch {
 public:
  explicit PlaceSearch(const PlaceMatcher& matcher) : matcher_(matcher) {}

  /// True if a search is in progress, or a deeper one is due with the next scan.
  [[nodiscard]] bool is_pending() const { return search_.has_value() || goes_on_; }
  /// Continues the search by about `slice` tiles; starts one with this scan if none is in progress.
  /// Returns the places found, refined on this scan, once the search is complete. `T_odom_base` is
  /// the odometry at the scan. Spends the work from `budget`.
  std::optional<FoundPlaces> step(const CreateContext& context, const ScanPoints& points,
                                  const SE2& T_odom_base, std::int64_t slice, WorkBudget& budget);
  /// Drops the search in progress; the next one is quick.
  void cancel();

 private:
  const PlaceMatcher& matcher_;
  std::optional<MapSearch> search_;
  SearchDepth depth_ = SearchDepth::kQuick;  ///< Of the search in progress or the next one.
  int deep_candidates_ = 0;                  ///< Of the next deep search.
  bool goes_on_ = false;                     ///< A deep search is due with the next scan.
};

/// Refines the candidates that a complete search has found on a scan, the best `most` of them.
/// Spends the work from `budget`.
FoundPlaces refine_found(const CreateContext& context, const MapSearch& search,
                         const ScanPoints& points, const SE2& T_odom_base, int most,
                         WorkBudget& budget);

/// Searches the whole map at once, as deep as `PlaceSearch`. Returns the places found, refined.
std::vector<WeighedPlace> find_places(const CreateContext& context, const PlaceMatcher& matcher,
                                      const ScanPoints& points);

}  // namespace castaway::localization
