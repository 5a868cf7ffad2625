/// AMCL's particle filter: KLD-sampling, and random particles when the average weight falls.
#pragma once

#include <optional>
#include <vector>

#include "localization/amcl/amcl_config.hpp"

namespace castaway::localization {

/// One population of particles on one map.
class AmclFilter {
 public:
  /// Starts without particles. @throws std::invalid_argument for a map without free cells.
  AmclFilter(const AmclConfig& config, const OccupancyGrid& map, Rng rng);

  /// Draws the maximum number of particles: around `start`, or anywhere on the map.
  void start(const std::optional<PoseWithCovariance>& start);
  void predict(const DifferentialMotion& motion);
  /// Multiplies the weights, given the logarithms of the factors in the order of the particles.
  void weigh(const std::vector<double>& log_weights);
  void resample();
  [[nodiscard]] const ParticleSet& particles() const { return particles_; }

 private:
  KldConfig kld_;
  InitialSpread initial_;
  FreeSpace free_space_;
  RecoveryAverages averages_;
  Rng rng_;
  ParticleSet particles_;
};

}  // namespace castaway::localization
