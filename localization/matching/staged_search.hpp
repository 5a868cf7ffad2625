/// Several searches by branch and bound, one after the other, for one list of the best places.
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

}  // namespace castaway::localization
