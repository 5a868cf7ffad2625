/// The alarm: whether the output is declared lost.
///
/// A lost output needs a higher probability to be found than a found one needs to stay so
/// (hysteresis): under perceptual aliasing or with an outdated map, the errors of consecutive scans
/// are correlated, so the probability of a recent output is overestimated.
#pragma once

#include <optional>

#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Conditions for being found.
struct LostAndFoundConfig {
  double found = 0.998;  ///< Minimum probability at which a lost output counts as found.
  double stays = 0.95;   ///< Minimum probability at which a found output stays found.
  /// [nats] A jump of the output is unexplained if no recent kidnap cue (which decays by 1 per new
  /// scan) reaches this.
  double unexplained_cue = -5.0;
  double proving_m = 5.0;  ///< [m] After such a jump, the robot must move this far to be found.
};

/// State of the output after a selection.
struct OutputClaim {
  bool same = false;         ///< The selection kept the previous output.
  bool confident = false;    ///< Probable enough not to be searched for.
  double probability = 0.0;  ///< In [0, 1].
};

/// Tracks the alarm over time.
class LostAndFound {
 public:
  explicit LostAndFound(const LostAndFoundConfig& config) : config_(config) {}

  /// Restarts; `known` is true if the user gave the start pose, which counts as found.
  void start(bool known);
  /// Forgets an unexplained jump, because odometry is not continuous with it any more.
  void forget_motion() { T_odom_jump_.reset(); }
  /// Updates the alarm after a selection. `cue` is the highest recent kidnap cue, `T_odom_base` the
  /// odometry at the newest scan, if there is one.
  void take(const OutputClaim& output, double cue, const std::optional<SE2>& T_odom_base);

  [[nodiscard]] bool is_lost() const { return !found_; }

 private:
  [[nodiscard]] bool is_proven(const std::optional<SE2>& T_odom_base) const;

  LostAndFoundConfig config_;
  bool found_ = false;
  bool was_found_ = false;          ///< At any time since the start.
  std::optional<SE2> T_odom_jump_;  ///< Odometry at the latest jump, if that is unexplained.
};

}  // namespace castaway::localization
