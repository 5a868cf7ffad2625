/// What the scans so far say of all places: the evidence of every hypothesis, and of "somewhere
/// unlisted" beside them.
#pragma once

#include <vector>

#include "localization/hypotheses/scan_log.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Weighs hypotheses against each other and against none of them.
class Posterior {
 public:
  /// Remembers what `log` keeps. `evidence` outlives it.
  Posterior(const PosteriorConfig& config, ScanLog log, const EvidenceModel& evidence);

  /// Begins anew; `known`: the user said where the robot is.
  void start(bool known);
  /// Forgets the scans: odometry does not lead back to them any more.
  void forget_motion() { log_.forget_motion(); }

  /// Adds a scan to the evidence of all hypotheses and of what is unlisted.
  void weigh(const ScanPoints& points, const SE2& T_odom_base, int output_id,
             std::vector<Hypothesis>& hypotheses);
  /// Takes the newest scan, if any, for one that was taken at the output.
  void learn(double log_likelihood);
  /// Takes what a search of the whole map found best; `hypotheses` have what it found in them.
  void take_search(double best_found, const std::vector<Hypothesis>& hypotheses);

  /// Probabilities of the hypotheses; what misses from 1 is unlisted.
  [[nodiscard]] std::vector<double> shares(const std::vector<Hypothesis>& hypotheses) const;
  /// Log-likelihood that a right pose usually has.
  [[nodiscard]] double usual() const { return unlisted_.usual; }
  [[nodiscard]] const ScanLog& log() const { return log_; }

 private:
  PosteriorConfig config_;
  ScanLog log_;
  const EvidenceModel& evidence_;
  Unlisted unlisted_;
};

}  // namespace castaway::localization
