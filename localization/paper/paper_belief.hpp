/// The belief of the paper's MH-AMCL: all populations, and which of them is the output.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/hypotheses/populations.hpp"
#include "localization/hypotheses/spawn.hpp"
#include "localization/paper/paper_config.hpp"
#include "localization/paper/patience.hpp"

namespace castaway::localization {

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
