/// The stages of the paper's MH-AMCL, each conditioned on settings and map.
///
/// Stages are functions so that a variant of the method can replace some of them and leave the
/// rest.
#pragma once

#include <functional>
#include <vector>

#include "localization/hypotheses/populations.hpp"
#include "localization/paper/paper_config.hpp"
#include "localization/sensor/sensor_input.hpp"

namespace castaway::localization {

/// A scan as the matcher may take it.
struct MatchScan {
  const LaserScan& scan;
  const ScanTurn& turn;                ///< The same as points in base.
  const TransformBuffer& T_odom_base;  ///< Motion up to now.
};

/// What is done to populations, in the order of a scan. None of the functions is empty.
struct PaperStages {
  /// Moves all particles by a step of odometry (eq. 3 and 4).
  std::function<void(const SE2& u, std::vector<Hypothesis>&)> predict;
  /// Weighs a population by a scan and takes its quality (eq. 5 to 7 and 9).
  std::function<void(const ScanPoints&, Hypothesis&)> correct;
  /// Joins populations in one place.
  std::function<void(Populations&)> merge;
  /// Id of the population that should be the output; populations are there.
  std::function<int(const Populations&)> prefer;
  double patience_s = 0.0;  ///< [s] It becomes the output after having been preferred for so long.
  /// Places where a scan fits, best first (section IV-A).
  std::function<std::vector<Candidate>(const MatchScan&)> match;
  /// Takes the first quality of a new population.
  std::function<void(const ScanPoints&, Hypothesis&)> judge_new;
  /// Removes populations that are wrong.
  std::function<void(Populations&)> destroy;
  /// Copies winners in place of losers (section III-C).
  std::function<void(Hypothesis&)> reseed;
  /// Merges, destroys and selects with every correction, not only when the matcher runs.
  bool manages_always = true;
};

/// The paper's. Throws std::invalid_argument for a map or a sensor that make no sense.
PaperStages paper_stages(const PaperMhAmclConfig& config, const OccupancyGrid& map);

}  // namespace castaway::localization
