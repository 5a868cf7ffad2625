#include "localization/paper/quality_rules.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "localization/hypotheses/populations.hpp"

namespace castaway::localization {
namespace {

/// Adds the particles of a population with their normalised weights times `factor`.
void add_weighted(const Hypothesis& h, double factor, ParticleSet& all) {
  const std::vector<double> weights = normalized_weights(h.particles);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    all.poses.push_back(h.particles.poses[i]);
    all.log_weights.push_back(std::log(std::max(weights[i] * factor, 1e-300)));
  }
}

/// Merges `second` into `first`.
void join(const Hypothesis& second, Hypothesis& first) {
  first.particles = heavier_half(first, first.quality, second, second.quality);
  first.belief = moments(first.particles);
  first.quality = std::max(first.quality, second.quality);
  first.log_weight = std::max(first.log_weight, second.log_weight);
}

}  // namespace

ParticleSet heavier_half(const Hypothesis& a, double factor_a, const Hypothesis& b,
                         double factor_b) {
  ParticleSet all;
  add_weighted(a, factor_a, all);
  add_weighted(b, factor_b, all);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return all.log_weights[i] > all.log_weights[j];
  });
  order.resize(std::max(a.particles.size(), b.particles.size()));
  ParticleSet best;
  for (const std::size_t i : order) {
    best.poses.push_back(all.poses[i]);
    best.log_weights.push_back(all.log_weights[i]);
  }
  return best;
}

void merge_by_weight(const MergeConfig& config, std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    for (std::size_t j = i + 1; j < hypotheses.size();) {
      if (same_place(config, hypotheses[i].belief.mean, hypotheses[j].belief.mean)) {
        join(hypotheses[j], hypotheses[i]);
        hypotheses.erase(hypotheses.begin() + static_cast<std::ptrdiff_t>(j));
      } else {
        ++j;
      }
    }
  }
}

void destroy_by_quality(const QualityRules& rules, std::vector<Hypothesis>& hypotheses) {
  const auto best = best_by_quality(hypotheses);
  if (!best) return;
  std::erase_if(hypotheses, [&, keep = hypotheses[*best].id](const Hypothesis& h) {
    return h.id != keep && h.quality < rules.destroy_below;
  });
}

int prefer_by_quality(const QualityRules& rules, const std::vector<Hypothesis>& hypotheses,
                      int output_id) {
  assert(!hypotheses.empty());
  const Hypothesis& best = hypotheses[*best_by_quality(hypotheses)];
  const Hypothesis* present = find_hypothesis(hypotheses, output_id);
  const bool stays = present != nullptr && !(best.quality > present->quality + rules.select_margin);
  return stays ? output_id : best.id;
}

bool is_apart(const QualityRules& rules, const std::vector<Hypothesis>& hypotheses,
              const SE2& T_map_base) {
  return std::all_of(hypotheses.begin(), hypotheses.end(), [&](const Hypothesis& h) {
    return distance(h.belief.mean, T_map_base) >= rules.apart_m ||
           yaw_distance(h.belief.mean, T_map_base) >= rules.apart_rad;
  });
}

std::optional<std::size_t> best_by_quality(const std::vector<Hypothesis>& hypotheses) {
  if (hypotheses.empty()) return std::nullopt;
  const auto best = std::max_element(
      hypotheses.begin(), hypotheses.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.quality < b.quality; });
  return static_cast<std::size_t>(best - hypotheses.begin());
}

}  // namespace castaway::localization
