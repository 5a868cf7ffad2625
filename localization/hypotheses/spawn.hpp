/// Spawn: creates a population at a place (paper, section IV).
#pragma once

#include <cstdint>
#include <optional>

#include "localization/filter/reseed.hpp"
#include "localization/hypotheses/hypothesis.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Spread that is added to the covariance of a given or found pose, which is never exact.
struct SpawnConfig {
  double sigma = 0.05;      ///< [m] Standard deviation in x and y.
  double sigma_yaw = 0.02;  ///< [rad]
};

/// Creates populations, each with its own id and random stream.
class Spawner {
 public:
  /// `size` gives the number of particles for a covariance. With settings of a mixture, populations
  /// are mixtures in place of particles.
  Spawner(const SpawnConfig& config, const ReseedConfig& size, std::uint64_t seed,
          const std::optional<MixtureConfig>& mixture = {})
      : config_(config), size_(size), mixture_(mixture), seed_(seed) {}

  /// Returns a new population with particles drawn from `belief`, or its mixture; `evidence` is
  /// that of the newest scan.
  Hypothesis spawn(const PoseMoments& belief, double log_weight, const Evidence& evidence);

 private:
  SpawnConfig config_;
  ReseedConfig size_;
  std::optional<MixtureConfig> mixture_;
  std::uint64_t seed_;
  int next_id_ = 0;
};

}  // namespace castaway::localization
