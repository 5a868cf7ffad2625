/// Finds where on a map a scan could have been taken.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "localization/matching/branch_and_bound.hpp"

namespace castaway::localization {

/// A part of the places that are searched, with the scan as it looks there.
struct SearchStage {
  const Pyramid* pyramid;  ///< Must outlive the search.
  SearchSpace space;
  std::vector<std::vector<CellOffset>> scans;  ///< Rotated by each of the yaws of the space.
};

/// The search. It can be interrupted and resumed as each of its stages.
class StagedSearch {
 public:
  /// `perfect`: score of a scan that fits perfectly. Without stages it is complete.
  StagedSearch(std::vector<SearchStage> stages, BestPlaces best, double perfect);

  /// Continues as `BranchAndBound::step`.
  bool step(std::int64_t tiles);
  [[nodiscard]] bool complete() const { return !current_; }
  /// Work so far (`TileScorer::scored`).
  [[nodiscard]] std::int64_t tiles_scored() const;
  /// The best places so far.
  [[nodiscard]] const BestPlaces& best() const { return current_ ? current_->best() : best_; }
  [[nodiscard]] double perfect() const { return perfect_; }

 private:
  void begin_stage();

  std::vector<SearchStage> stages_;
  BestPlaces best_;  ///< Those of the stages that are complete.
  double perfect_;
  std::size_t stage_ = 0;
  std::int64_t scored_ = 0;                ///< By these stages.
  std::optional<BranchAndBound> current_;  ///< None: complete.
};

/// A pose at which a scan fits the map.
struct Candidate {
  SE2 T_map_base;  ///< Centre of the coarse cell and yaw of the step; in the atlas of a 3-D map.
  double score = 0.0;  ///< In [0, 1]: mean of the bytes under the end points.
};

/// Searches one map.
class PlaceMatcher {
 public:
  PlaceMatcher() = default;
  virtual ~PlaceMatcher() = default;
  PlaceMatcher(const PlaceMatcher&) = delete;
  PlaceMatcher& operator=(const PlaceMatcher&) = delete;
  PlaceMatcher(PlaceMatcher&&) = default;
  PlaceMatcher& operator=(PlaceMatcher&&) = default;

  /// Size of the map in coarse cells.
  [[nodiscard]] virtual std::size_t cells() const = 0;
  /// Returns candidates on free cells, best first; none for a scan without points. `most` overrides
  /// the configured number.
  [[nodiscard]] virtual std::vector<Candidate> match(const ScanPoints& points,
                                                     const std::optional<MatchWindow>& window = {},
                                                     const std::optional<int>& most = {}) const = 0;
  /// Starts a match of the whole map that runs in slices, always by branch and bound; the matcher
  /// must outlive it. Places with a score (`Candidate::score`) below `least` are left out, which
  /// prunes the search.
  [[nodiscard]] virtual StagedSearch search(const ScanPoints& points,
                                            const std::optional<int>& most = {},
                                            double least = 0.0) const = 0;
  /// Candidates that a search has found so far.
  [[nodiscard]] virtual std::vector<Candidate> candidates(const StagedSearch& search) const = 0;
};

}  // namespace castaway::localization
