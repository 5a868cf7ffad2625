/// Finds where on the map a scan could have been taken: every coarse cell and yaw, then the best of
/// every neighbourhood, to be refined at full resolution (`refine_pose`).
///
/// After the cascade of the paper (section IV-A) with two changes: yaws every 3 degrees instead of
/// pi/8, and levels whose bounds are admissible, so that no level loses what the next one would
/// have found.
#pragma once

#include "localization/matching/branch_and_bound.hpp"
#include "localization/matching/score_volume.hpp"

namespace castaway::localization {

/// How all of a map is searched; the candidates are the same.
enum class MatchAlgorithm {
  kBranchAndBound,  ///< Two to seven times as fast (`localization_bench`).
  kExhaustive,      ///< Constant time.
};

/// Parameters of the search.
struct MatcherConfig {
  ByteFieldConfig field;
  double yaw_step = 0.0524;    ///< [rad] About 3 degrees; rounded so that whole steps make a turn.
  int points = 64;             ///< End points used, even over the scan; at most 256.
  int candidates = 100;        ///< At most so many are returned, unless more are asked for.
  double suppression_m = 1.6;  ///< [m] Only the best of a square of this size...
  double suppression_rad = 0.1745;  ///< [rad] ...and of this range of yaws is kept.
  MatchAlgorithm algorithm = MatchAlgorithm::kBranchAndBound;
  int levels = 3;  ///< Of the pyramid of branch and bound, each twice as coarse as the last.
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const MatcherConfig& config);

/// A place where a scan fits.
struct Candidate {
  SE2 T_map_base;      ///< Centre of the coarse cell, yaw of the step.
  double score = 0.0;  ///< In [0, 1]: mean of the bytes under the end points.
};

/// Searches one map.
class CascadeMatcher {
 public:
  CascadeMatcher(const MatcherConfig& config, const OccupancyGrid& grid,
                 const DistanceField& distances);

  [[nodiscard]] const MatcherConfig& config() const { return config_; }
  /// Candidates on free cells, best first; none for a scan without points. `most`: other than the
  /// configured number.
  [[nodiscard]] std::vector<Candidate> match(const ScanPoints& points,
                                             const std::optional<MatchWindow>& window = {},
                                             const std::optional<int>& most = {}) const;

  /// A match to be done in slices, by branch and bound whatever is configured; the matcher outlives
  /// it.
  [[nodiscard]] BranchAndBound search(const ScanPoints& points,
                                      const std::optional<MatchWindow>& window = {},
                                      const std::optional<int>& most = {}) const;
  /// What a search of a scan with so many points has found so far.
  [[nodiscard]] std::vector<Candidate> candidates(const BestPlaces& best, std::size_t points) const;

 private:
  [[nodiscard]] BestPlaces nothing_found(int most) const;
  [[nodiscard]] std::vector<std::vector<CellOffset>> turned(const ScanPoints& points,
                                                            const SearchSpace& space) const;

  MatcherConfig config_;
  ByteField field_;
  Pyramid pyramid_;
  int yaws_ = 0;
};

}  // namespace castaway::localization
