/// Start: a population of particles begins where the robot may be (paper, section IV).
#pragma once

#include <cstdint>

#include "localization/filter/reseed.hpp"
#include "localization/hypotheses/hypothesis.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Spread that is added to that of the belief: what is told or found is never exact.
struct SpawnConfig {
  double sigma = 0.05;      ///< [m] Of a new population...
  double sigma_yaw = 0.02;  ///< [rad] ...and of its yaw.
};

/// Makes populations, each with an id and a stream of random numbers of its own.
class Spawner {
 public:
  /// `size`: how many particles a population of a spread has.
  Spawner(const SpawnConfig& config, const ReseedConfig& size, std::uint64_t seed)
      : config_(config), size_(size), seed_(seed) {}

  /// A population that is as heavy as `log_weight` and saw the newest scan as `evidence` says.
  Hypothesis spawn(const PoseMoments& belief, double log_weight, const Evidence& evidence);

 private:
  SpawnConfig config_;
  ReseedConfig size_;
  std::uint64_t seed_;
  int next_id_ = 0;
};

}  // namespace castaway::localization
