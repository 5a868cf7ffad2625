/// The belief of the paper's MH-AMCL: all populations, and which of them is the output.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "castaway/stamp.hpp"
#include "localization/hypotheses/populations.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/paper/paper_config.hpp"

namespace castaway::localization {

/// Stores since when another population is preferred.
class Patience {
 public:
  explicit Patience(double wait_s) : wait_s_(wait_s) {}

  /// Returns the id of the output: the present one or, if it is gone or another one has been
  /// preferred for long enough, the preferred one.
  int settle(std::optional<int> present, int preferred, Stamp now);
  /// Restarts the wait.
  void reset() { since_.reset(); }

 private:
  double wait_s_;
  std::optional<Stamp> since_;
};

/// Populations weighted by quality; the paper has no null hypothesis.
struct PaperBelief {
  /// Starts without populations. `patience_s` as in `PaperStages`.
  PaperBelief(const PaperMhAmclConfig& config, double patience_s, std::uint64_t seed);

  /// Removes all populations.
  void clear();
  /// Adds a population with particles drawn from `belief`.
  Hypothesis& add(const PoseMoments& belief);
  /// Makes the population with id `preferred` the output, after the patience. Requires populations.
  void select(int preferred, Stamp now);

  /// Sets the stated probability to the quality of the output, if there is one.
  void update_probability();
  /// Posterior probabilities of the populations.
  [[nodiscard]] std::vector<double> shares() const;

  Spawner spawner;
  Patience patience;
  Populations populations;
};

}  // namespace castaway::localization
