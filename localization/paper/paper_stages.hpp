/// The stages of the paper's MH-AMCL, each bound to settings and map.
///
/// Stages are functions, so that a variant of the method can replace some of them.
#pragma once

#include <functional>
#include <vector>

#include "localization/hypotheses/populations.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/paper/paper_config.hpp"

namespace castaway::localization {

/// A scan for the matcher.
struct MatchScan {
  const LaserScan& scan;
  const ScanTurn& turn;                ///< The same scan as points in base.
  const TransformBuffer& T_odom_base;  ///< Motion up to now.
};

/// Operations on populations, in the order of their use in a scan. None of the functions is empty.
struct PaperStages {
  /// Moves all particles by a step of odometry (eq. 3 and 4).
  std::function<void(const SE2& u, std::vector<Hypothesis>&)> predict;
  /// Updates weights and quality of a population by a scan (eq. 5 to 7 and 9).
  std::function<void(const ScanPoints&, Hypothesis&)> correct;
  /// Merges populations at the same place.
  std::function<void(Populations&)> merge;
  /// Id of the population that should be the output; requires populations.
  std::function<int(const Populations&)> prefer;
  /// [s] A population becomes the output after having been preferred for this long.
  double patience_s = 0.0;
  /// Returns the places where a scan fits, best first (section IV-A).
  std::function<std::vector<Candidate>(const MatchScan&)> match;
  /// Sets the initial quality of a new population.
  std::function<void(const ScanPoints&, Hypothesis&)> judge_new;
  /// Removes wrong populations.
  std::function<void(Populations&)> destroy;
  /// Replaces losers by copies of winners (section III-C).
  std::function<void(Hypothesis&)> reseed;
  /// Merges, destroys and selects at every correction, not only when the matcher runs.
  bool manages_always = true;
};

/// The paper's stages. @throws std::invalid_argument for an invalid map or sensor.
PaperStages paper_stages(const PaperMhAmclConfig& config, const OccupancyGrid& map);

}  // namespace castaway::localization
