/// Recovery by random particles, as in AMCL, when the short-term average weight falls below the
/// long-term one.
///
/// S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics" (2005), table 8.3 (augmented MCL).
#pragma once

namespace castaway::localization {

/// Decay rates of the averages; 0 and 0 switch recovery off.
struct RecoveryConfig {
  double alpha_slow = 0.0;
  double alpha_fast = 0.0;
};

/// The short-term and long-term averages.
class RecoveryAverages {
 public:
  explicit RecoveryAverages(const RecoveryConfig& config) : config_(config) {}

  /// Adds the mean unnormalised weight of an update.
  void add(double mean_weight);
  /// Probability of a random particle, `max(0, 1 - fast / slow)`.
  [[nodiscard]] double random_share() const;
  /// Resets both averages, as after a burst of random particles.
  void reset();

 private:
  RecoveryConfig config_;
  double slow_ = 0.0;
  double fast_ = 0.0;
};

}  // namespace castaway::localization
