/// Recovery by random particles, as AMCL has it: a fall of the short-term average weight below the
/// long-term one.
///
/// S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics" (2005), table 8.3 (augmented MCL).
#pragma once

namespace castaway::localization {

/// Rates of the averages; 0 and 0 switch recovery off.
struct RecoveryConfig {
  double alpha_slow = 0.0;
  double alpha_fast = 0.0;
};

/// The two averages.
class RecoveryAverages {
 public:
  explicit RecoveryAverages(const RecoveryConfig& config) : config_(config) {}

  /// Takes the mean unnormalised weight of an update.
  void add(double mean_weight);
  /// Probability of a random particle, `max(0, 1 - fast / slow)`.
  [[nodiscard]] double random_share() const;
  /// Starts anew, as after a burst of random particles.
  void reset();

 private:
  RecoveryConfig config_;
  double slow_ = 0.0;
  double fast_ = 0.0;
};

}  // namespace castaway::localization
