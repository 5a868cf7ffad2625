/// Posterior over places: the accumulated evidence of every hypothesis and of the null hypothesis.
///
/// Scans of a robot that hardly moves repeat each other. Only the share e of a scan
/// (`independence`) counts as new, but a sudden drop of the likelihood counts at once: `w += L_t -
/// (1 - e) L_{t-1}`.
#pragma once

#include <optional>
#include <vector>

#include "localization/hypotheses/null_hypothesis.hpp"
#include "localization/hypotheses/scan_log.hpp"
#include "localization/sensor/evidence_model.hpp"

namespace castaway::localization {

/// Parameters of the posterior.
struct PosteriorConfig {
  ScanComparisonConfig scans;
  NullHypothesisConfig null;
  /// [nats] Log-probability that the robot was brought to one given place in one period of the rate
  /// of corrections.
  double place = -14.0;
};

/// Weighs hypotheses against each other and against the null hypothesis.
class Posterior {
 public:
  /// Stores the scans in `log`. `evidence` must outlive it.
  Posterior(const NullHypothesisConfig& config, ScanLog log, const EvidenceModel& evidence);

  /// Restarts; `known` is true if the user gave the start pose.
  void start(bool known);
  /// Forgets the scans, because odometry is not continuous with them any more.
  void forget_motion() { log_.forget_motion(); }

  /// Adds the evidence of a scan to all hypotheses and to the null hypothesis.
  /// `periods` of the rate of corrections have passed since the previous scan.
  void weigh(const ScanPoints& points, const SE2& T_odom_base, int output_id,
             std::vector<Hypothesis>& hypotheses, double periods = 1.0);
  /// Learns the usual log-likelihood from that of the newest scan, if any, at a confident output.
  void learn(double log_likelihood);
  /// Updates the null hypothesis by the best place that a search of the whole map has found.
  /// `hypotheses` include the places found.
  void take_search(const BestFound& best, const std::vector<Hypothesis>& hypotheses);
  /// Updates the weight of the places left out by that of those which a search left out [nats];
  /// nothing: it left out none that fits as well as those found.
  void take_left_out(const std::optional<double>& log_weight);
  /// Updates the doubt by a search of the whole map for places as good as the output. `output` is
  /// the output, with its lead over the best place elsewhere (negative if that place is better);
  /// `bounds` is true if the null hypothesis is bounded as by `take_search`.
  void take_watch(const BestFound& output, bool bounds, const std::vector<Hypothesis>& hypotheses);

  /// Ends the doubt, because the output is at another place now: it was doubt of the former one.
  void forget_doubt() { null_.doubt = 0.0; }

  /// Posterior probabilities of the hypotheses; the remainder to 1 is the null hypothesis.
  [[nodiscard]] std::vector<double> shares(const std::vector<Hypothesis>& hypotheses) const;
  /// [nats] Usual log-likelihood of a scan at the right pose.
  [[nodiscard]] double usual() const { return null_.usual; }
  /// [nats] The usual log-likelihood minus the mean deviation from it.
  [[nodiscard]] double least_usual() const { return null_.usual - null_.spread; }
  /// [nats] Evidence that the output has become wrong (`take_doubt`).
  [[nodiscard]] double doubt() const { return null_.doubt; }
  /// [nats] The larger of the doubt and of the evidence of the newest scan alone, which has this
  /// log-likelihood at the output.
  [[nodiscard]] double suspicion(double log_likelihood) const;
  [[nodiscard]] const ScanLog& log() const { return log_; }

 private:
  NullHypothesisConfig config_;
  ScanLog log_;
  const EvidenceModel& evidence_;
  NullHypothesis null_;
  double new_since_watch_ = 0.0;  ///< New share of the scans since the last `take_watch`.
};

}  // namespace castaway::localization
