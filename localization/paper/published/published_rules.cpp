#include "localization/paper/published/published_rules.hpp"

#include <algorithm>
#include <cmath>

#include "localization/paper/published/published_moments.hpp"

namespace castaway::localization {
namespace {

/// Scales the position by the sum of the weights.
void scale_mean(Hypothesis& hypothesis) {
  double sum = 0.0;
  for (const double log_weight : hypothesis.particles.log_weights) sum += std::exp(log_weight);
  hypothesis.belief.mean.x *= sum;
  hypothesis.belief.mean.y *= sum;
}

/// Merges `second` into `first`.
void join_published(const PublishedDefects& defects, const Hypothesis& second, Hypothesis& first) {
  const bool raw = defects.unnormalised_merge;
  first.particles =
      heavier_half(first, raw ? 1.0 : first.quality, second, raw ? 1.0 : second.quality);
  first.belief = published_moments(first.particles, defects);
  if (raw) scale_mean(first);
  first.quality = std::max(first.quality, second.quality);
  first.log_weight = std::max(first.log_weight, second.log_weight);
}

/// Removes a population. The output jumps to the first population if the published code compares it
/// with the successor of the removed one.
void remove(std::size_t index, const PublishedDefects& defects, Populations& populations) {
  std::vector<Hypothesis>& all = populations.all;
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(index));
  if (!defects.neighbour_compared || index >= all.size()) return;
  if (all[index].id == populations.output_id) populations.output_id = all.front().id;
}

/// Merges all populations after `first` that are at its place into it.
void merge_into(std::size_t first, const MergeConfig& config, const PublishedDefects& defects,
                Populations& populations) {
  std::vector<Hypothesis>& all = populations.all;
  for (std::size_t j = first + 1; j < all.size();) {
    if (same_place(config, all[first].belief.mean, all[j].belief.mean)) {
      join_published(defects, all[j], all[first]);
      remove(j, defects, populations);
    } else {
      ++j;
    }
  }
}

}  // namespace

void published_merge(const MergeConfig& config, const PublishedDefects& defects,
                     Populations& populations) {
  for (std::size_t i = 0; i < populations.all.size(); ++i) {
    if (defects.first_merges_only && i > 0) break;
    merge_into(i, config, defects, populations);
  }
}

void published_destroy(const PublishedMhAmclConfig& config, Populations& populations) {
  const QualityRules& rules = config.paper.rules;
  const auto best = best_by_quality(populations.all);
  if (!best) return;
  const int keep = populations.all[*best].id;
  const auto must_go = [&](const Hypothesis& h) {
    if (!config.defects.absolute_gates) return h.id != keep && h.quality < rules.destroy_below;
    return fails_gates(config.gates, h, populations.all.size(), rules.most);
  };
  for (std::size_t i = 0; i < populations.all.size();) {
    if (must_go(populations.all[i])) {
      remove(i, config.defects, populations);
    } else {
      ++i;
    }
  }
}

}  // namespace castaway::localization
