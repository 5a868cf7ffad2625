#include "localization/paper/published/published_config.hpp"

#include <cassert>

#include <boost/random/normal_distribution.hpp>

#include "localization/hypotheses/populations.hpp"

namespace castaway::localization {

int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id) {
  assert(!hypotheses.empty());
  const Hypothesis* output = find_hypothesis(hypotheses, output_id);
  if (output == nullptr) output = &hypotheses.front();
  for (const Hypothesis& h : hypotheses) {
    if (h.quality > gates.good && h.quality > output->quality + gates.margin) output = &h;
  }
  return output->id;
}

bool fails_gates(const PublishedGates& gates, const Hypothesis& hypothesis, std::size_t count,
                 int most) {
  const bool full = count >= static_cast<std::size_t>(most);
  return count > 1 && hypothesis.quality < (full ? gates.low : gates.very_low);
}

SE2 StepNoiseMotion::sample(const SE2& T_map_base0, Rng& rng) const {
  boost::random::normal_distribution<double> normal;
  const double trans = config_.trans * normal(rng);
  const double rot = config_.rot * normal(rng);
  return T_map_base0 * u_ * SE2{u_.x * trans, u_.y * trans, u_.yaw * rot};
}

PublishedMhAmclConfig published_config() {
  PublishedMhAmclConfig config;
  config.defects = all_defects();
  PaperMhAmclConfig& paper = config.paper;
  paper.candidate_sigma = 0.1;
  paper.candidate_sigma_yaw = 0.05;
  paper.reseed.winners = 0.03;
  paper.reseed.spread_m = paper.candidate_sigma;
  paper.reseed.spread_rad = paper.candidate_sigma_yaw;
  return config;
}

}  // namespace castaway::localization
