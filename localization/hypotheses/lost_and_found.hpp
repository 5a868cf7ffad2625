/// Whether the output calls itself lost: the alarm.
///
/// Having been lost it takes more to be found than to stay so: where a map has look-alikes or is
/// out of date, scan after scan errs the same way, and the first few are believed too readily.
#pragma once

#include <optional>

#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// What it takes to be found.
struct LostAndFoundConfig {
  double found = 0.998;           ///< An output that was lost is found from so probable on.
  double unexplained_cue = -5.0;  ///< Where no kidnap cue has been above this lately (it fades by a
                                  ///< nat per new scan), an output that jumps...
  double proving_m = 5.0;         ///< [m] ...is not found before the robot went so far.
};

/// The output as the alarm sees it.
struct OutputClaim {
  bool same = false;       ///< It is the output of before.
  bool confident = false;  ///< It is probable enough not to be lost.
  double probability = 0.0;
};

/// Keeps the alarm over time.
class LostAndFound {
 public:
  explicit LostAndFound(const LostAndFoundConfig& config) : config_(config) {}

  /// Begins anew; `known`: the user said where the robot is, which counts.
  void start(bool known);
  /// Forgets a jump: odometry does not lead back to it any more.
  void forget_motion() { T_odom_jump_.reset(); }
  /// Takes the output selected. `cue`: the highest one of a kidnap lately; `T_odom_base`: odometry
  /// at the newest scan, if there is one.
  void take(const OutputClaim& output, double cue, const std::optional<SE2>& T_odom_base);

  [[nodiscard]] bool is_lost() const { return !found_; }

 private:
  [[nodiscard]] bool is_proven(const std::optional<SE2>& T_odom_base) const;

  LostAndFoundConfig config_;
  bool found_ = false;
  bool was_found_ = false;          ///< At any time since the start.
  std::optional<SE2> T_odom_jump_;  ///< Odometry at a jump of the output that no kidnap explains.
};

}  // namespace castaway::localization
