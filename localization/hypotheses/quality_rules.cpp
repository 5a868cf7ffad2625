#include "localization/hypotheses/quality_rules.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "localization/filter/published_moments.hpp"

namespace castaway::localization {
namespace {

/// The heavier half of the particles of two populations, heaviest first, weighed by their share
/// times the population's quality; in the published code by their share alone.
ParticleSet heavier_half(const Hypothesis& a, const Hypothesis& b, bool by_quality) {
  ParticleSet all;
  for (const Hypothesis* h : {&a, &b}) {
    const std::vector<double> weights = normalized_weights(h->particles);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      all.poses.push_back(h->particles.poses[i]);
      const double weight = by_quality ? weights[i] * h->quality : weights[i];
      all.log_weights.push_back(std::log(std::max(weight, 1e-300)));
    }
  }
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

/// `second` goes into `first`.
void join(Hypothesis& first, const Hypothesis& second, const PublishedDefects& defects) {
  first.particles = heavier_half(first, second, !defects.unnormalised_merge);
  first.belief = published_moments(first.particles, defects);
  if (defects.unnormalised_merge) {
    double sum = 0.0;
    for (const double log_weight : first.particles.log_weights) sum += std::exp(log_weight);
    first.belief.mean.x *= sum;
    first.belief.mean.y *= sum;
  }
  first.quality = std::max(first.quality, second.quality);
  first.log_weight = std::max(first.log_weight, second.log_weight);
}

/// Removes one and returns the output's id, which jumps to the first population where the published
/// code takes the successor for the one that went.
int remove(std::size_t index, const PublishedDefects& defects, std::vector<Hypothesis>& hypotheses,
           int output_id) {
  hypotheses.erase(hypotheses.begin() + static_cast<std::ptrdiff_t>(index));
  const bool jumps =
      defects.neighbour_compared && index < hypotheses.size() && hypotheses[index].id == output_id;
  return jumps ? hypotheses.front().id : output_id;
}

/// Joins those after `first` that are in its place; returns the output's id.
int merge_into(std::size_t first, const MergeConfig& config, const PublishedDefects& defects,
               std::vector<Hypothesis>& hypotheses, int output_id) {
  for (std::size_t j = first + 1; j < hypotheses.size();) {
    if (same_place(config, hypotheses[first].belief.mean, hypotheses[j].belief.mean)) {
      join(hypotheses[first], hypotheses[j], defects);
      output_id = remove(j, defects, hypotheses, output_id);
    } else {
      ++j;
    }
  }
  return output_id;
}

}  // namespace

int merge_by_weight(const MergeConfig& config, std::vector<Hypothesis>& hypotheses,
                    const PublishedDefects& defects, int output_id) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (defects.first_merges_only && i > 0) break;
    output_id = merge_into(i, config, defects, hypotheses, output_id);
  }
  return output_id;
}

int destroy_by_quality(const QualityRules& rules, std::vector<Hypothesis>& hypotheses,
                       const PublishedDefects& defects, int output_id) {
  const auto best = best_by_quality(hypotheses);
  if (!best) return output_id;
  const int keep = hypotheses[*best].id;
  const auto must_go = [&](const Hypothesis& h) {
    if (!defects.absolute_gates) return h.id != keep && h.quality < rules.destroy_below;
    const bool full = hypotheses.size() >= static_cast<std::size_t>(rules.most);
    const double least = full ? rules.gates.low : rules.gates.very_low;
    return hypotheses.size() > 1 && h.quality < least;
  };
  for (std::size_t i = 0; i < hypotheses.size();) {
    if (must_go(hypotheses[i])) {
      output_id = remove(i, defects, hypotheses, output_id);
    } else {
      ++i;
    }
  }
  return output_id;
}

int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id) {
  assert(!hypotheses.empty());
  const auto present = std::find_if(hypotheses.begin(), hypotheses.end(),
                                    [&](const Hypothesis& h) { return h.id == output_id; });
  const Hypothesis* output = present == hypotheses.end() ? &hypotheses.front() : &*present;
  for (const Hypothesis& h : hypotheses) {
    if (h.quality > gates.good && h.quality > output->quality + gates.margin) output = &h;
  }
  return output->id;
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
