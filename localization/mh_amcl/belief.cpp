#include "localization/mh_amcl/belief.hpp"

#include <algorithm>

#include "localization/hypotheses/select.hpp"

namespace castaway::localization {
namespace {

/// Probability of a population to be at the same place as a pose, in [0, 1].
double share_near(const MergeConfig& config, const Hypothesis& hypothesis, const SE2& T_map_base) {
  if (!hypothesis.mixture.empty()) {
    return probability_near(hypothesis.mixture, T_map_base, config.distance, config.yaw);
  }
  const ParticleSet& particles = hypothesis.particles;
  const std::vector<double> weights = normalized_weights(particles);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (same_place(config, particles.poses[i], T_map_base)) sum += weights[i];
  }
  return sum;
}

}  // namespace

Belief::Belief(const MhAmclModels& mh_amcl_models, std::uint64_t seed)
    : models(mh_amcl_models),
      spawner(models.config.spawn, models.config.reseed, seed, mixture_of(models.config)),
      posterior(models.config.posterior.null,
                ScanLog({models.config.posterior.scans, models.config.agreement,
                         models.config.continuity, models.config.history}),
                models.evidence),
      lost_and_found(models.config.lost_and_found) {}

void Belief::start(const std::optional<PoseWithCovariance>& start) {
  populations = {};
  posterior.start(start.has_value());
  if (start) {
    const Evidence usual{posterior.usual(), 0.0};
    populations.all.push_back(spawner.spawn({start->T_map_base, start->covariance}, 0.0, usual));
    select();
  }
  lost_and_found.start(start.has_value());
}

void Belief::forget_motion() {
  posterior.forget_motion();
  lost_and_found.forget_motion();
}

void Belief::add(const std::vector<WeighedPlace>& places, const ScanPoints& points) {
  for (const WeighedPlace& place : places) {
    populations.all.push_back(spawner.spawn(models.filter.belief_at(place.T_map_base, points),
                                            place.log_weight, place.newest));
  }
}

bool Belief::select() {
  const auto selected =
      localization::select(populations.all, populations.output_id, models.config.select_margin);
  if (!selected) return false;
  const Hypothesis& output = populations.all[*selected];
  const bool was_confident = is_confident();
  const Hypothesis* before = populations.output();
  const bool same =
      before != nullptr && (output.replaces == before->id ||
                            models.rescue.reaches(before->belief.mean, output.belief.mean));
  if (!same) posterior.forget_doubt();
  populations.output_id = output.id;
  populations.probability = probability_at(output.belief.mean);
  lost_and_found.take({same, is_confident(), populations.probability}, posterior.log().recent_cue(),
                      posterior.log().T_odom_base());
  return was_confident && !is_confident();
}

double Belief::probability_at(const SE2& T_map_base) const {
  constexpr double kNegligible = 1e-7;
  const std::vector<double> share = shares();
  double sum = 0.0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    if (share[i] < kNegligible) continue;
    sum += share[i] * share_near(models.config.same, populations.all[i], T_map_base);
  }
  return std::min(sum, 1.0);
}

void Belief::learn() {
  const Hypothesis* output = populations.output();
  if (output != nullptr && is_confident()) posterior.learn(output->log_likelihood);
}

}  // namespace castaway::localization
