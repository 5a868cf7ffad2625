/// Budget of the search for places, counted in work and not by a clock, so that runs repeat.
///
/// Simulated (or log) time earns a share for each scan at the rate of corrections, whether it comes
/// or not, so that the load of the processor is what counts; a scan earns at least one share. What
/// a minute earns can be saved. Less budget finds places later.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "castaway/stamp.hpp"

namespace castaway::localization {

/// Time of a scan, tracking included, on a processor that scores 8000 tiles of a small map in a
/// millisecond.
struct WorkBudgetConfig {
  double mean_ms = 1.0;   ///< [ms] Average over a long run, for each scan that is due.
  double most_ms = 50.0;  ///< [ms] Upper limit of one scan.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const WorkBudgetConfig& config);

/// Tiles that such a processor scores in a millisecond on a map of `cells` cells: fewer if the map
/// is large, because it does not fit into the cache.
double tiles_per_ms(std::size_t cells);

/// Saves and spends tiles (`TileScorer::scored`).
class WorkBudget {
 public:
  /// `rate_hz` is the rate at which scans are due, `cells` the size of the map.
  WorkBudget(const WorkBudgetConfig& config, double rate_hz, std::size_t cells = 0);

  /// Restarts with all that can be saved.
  void start();
  /// Adds the share of the time since the scan before.
  void earn(Stamp now);
  /// Takes `tiles` off; the budget may become negative.
  void spend(std::int64_t tiles) {
    saved_ -= tiles;
    spent_ += tiles;
  }
  /// Tiles that may be searched now: at most `wanted` and what is left of the most that one scan
  /// may cost, and a few even if nothing is saved.
  [[nodiscard]] std::int64_t grant(std::int64_t wanted) const {
    const std::int64_t left = std::max<std::int64_t>(most_of_search_ - spent_, 0);
    return std::min({wanted, left, std::max(saved_, least_)});
  }
  /// True if the places found may be weighed with this scan, which costs `tiles` at once: this and
  /// what was spent are within what one scan may cost, or nothing was spent.
  [[nodiscard]] bool affords(std::int64_t tiles) const {
    return spent_ == 0 || spent_ + tiles <= most_;
  }

 private:
  double rate_hz_ = 1.0;
  std::int64_t per_scan_ = 0;
  std::int64_t most_ = 0;            ///< Of the searches of one scan and of what they found.
  std::int64_t most_of_search_ = 0;  ///< Of the searches of one scan.
  std::int64_t capacity_ = 0;        ///< Of the savings.
  std::int64_t least_ = 0;
  std::int64_t saved_ = 0;
  std::int64_t spent_ = 0;     ///< With this scan.
  std::optional<Stamp> last_;  ///< Time of the scan before.
};

}  // namespace castaway::localization
