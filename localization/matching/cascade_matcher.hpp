/// Finds where on the map a scan could have been taken: scores every coarse cell and yaw, and
/// returns the best of every neighbourhood, to be refined at full resolution (`refine_pose`).
///
/// After the cascade of the paper (section IV-A), with two changes: yaw steps of 3 degrees instead
/// of pi/8, and admissible bounds at all levels, so that no level drops what the next one would
/// have found.
///
/// Exhaustive search: the score of every free coarse cell at every yaw.
///
/// E. Olson, "Real-Time Correlative Scan Matching", ICRA 2009; 16 neighbouring places are scored at
/// once (`tile_sums`), because their bytes for one yaw and beam are adjacent in memory.
#pragma once

#include "localization/map/pooled_field.hpp"
#include "localization/matching/best_places.hpp"
#include "localization/matching/place_matcher.hpp"
#include "localization/matching/search_space.hpp"

namespace castaway::localization {

/// Offers all free cells of a space to `best`; `scans[i]` is the scan rotated by the yaw
/// `space.yaws[i]`. `cells` is the finest level, edge 1. Constant time: one byte sum for every
/// cell, yaw and end point.
void score_all(const PooledField& cells, const SearchSpace& space,
               const std::vector<std::vector<CellOffset>>& scans, BestPlaces& best);

/// How the whole map is searched; both give the same candidates.
enum class MatchAlgorithm {
  kBranchAndBound,  ///< Two to seven times as fast (`localization_bench`).
  kExhaustive,      ///< Constant time for a map.
};

/// Parameters of the search.
struct MatcherConfig {
  ByteFieldConfig field;
  /// [rad] About 3 degrees; rounded to a whole number of steps per turn.
  double yaw_step = 0.0524;
  int points = 64;       ///< Number of end points used, evenly spread over the scan; at most 256.
  int candidates = 100;  ///< Largest number of candidates, unless a call asks for another.
  /// [m] Only the best place in a square of this size and `suppression_rad` is kept.
  double suppression_m = 1.6;
  double suppression_rad = 0.1745;  ///< [rad] See `suppression_m`.
  MatchAlgorithm algorithm = MatchAlgorithm::kBranchAndBound;
  /// Levels of the pyramid of branch and bound, each twice as coarse as the previous one.
  int levels = 5;
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const MatcherConfig& config);

/// Number of yaws in a turn.
int yaw_steps(const MatcherConfig& config);

/// An empty list for a search of a grid of coarse cells.
BestPlaces make_best_places(const MatcherConfig& config, const GridFrame& frame, int most,
                            int least = 1);

/// Sum of the bytes of a scan of `points` points that fits perfectly.
double perfect_score(const MatcherConfig& config, std::size_t points);

/// Searches one planar map.
class CascadeMatcher final : public PlaceMatcher {
 public:
  CascadeMatcher(const MatcherConfig& config, const OccupancyGrid& grid,
                 const DistanceField& distances);

  [[nodiscard]] const MatcherConfig& config() const { return config_; }
  [[nodiscard]] std::size_t cells() const override { return field_.frame().size(); }
  [[nodiscard]] std::vector<Candidate> match(const ScanPoints& points,
                                             const std::optional<MatchWindow>& window = {},
                                             const std::optional<int>& most = {}) const override;
  [[nodiscard]] StagedSearch search(const ScanPoints& points, const std::optional<int>& most = {},
                                    double least = 0.0) const override;
  /// The same within a window.
  [[nodiscard]] StagedSearch search_within(const ScanPoints& points,
                                           const std::optional<MatchWindow>& window,
                                           const std::optional<int>& most = {},
                                           double least = 0.0) const;
  [[nodiscard]] std::vector<Candidate> candidates(const StagedSearch& search) const override;

 private:
  [[nodiscard]] std::vector<Candidate> candidates(const BestPlaces& best, double perfect) const;
  [[nodiscard]] std::vector<std::vector<CellOffset>> rotate_scans(const ScanPoints& points,
                                                                  const SearchSpace& space) const;

  MatcherConfig config_;
  ByteField field_;
  Pyramid pyramid_;
  int yaws_ = 0;
};

}  // namespace castaway::localization
