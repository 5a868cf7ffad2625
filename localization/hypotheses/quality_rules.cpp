#include "localization/hypotheses/quality_rules.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace castaway::localization {
namespace {

/// All particles of two populations, heaviest first, weighed by their share times the population's
/// quality.
ParticleSet heavier_half(const Hypothesis& a, const Hypothesis& b) {
  ParticleSet all;
  for (const Hypothesis* h : {&a, &b}) {
    const std::vector<double> weights = normalized_weights(h->particles);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      all.poses.push_back(h->particles.poses[i]);
      all.log_weights.push_back(std::log(std::max(weights[i] * h->quality, 1e-300)));
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

}  // namespace

void correct_by_rays(Hypothesis& hypothesis, const RayLocalModel& model, const ScanPoints& points) {
  if (points.empty()) return;
  double hits = 0.0;
  ParticleSet& particles = hypothesis.particles;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const RayLocalScore score = model.evaluate(points, particles.poses[i]);
    particles.log_weights[i] += score.log_likelihood;
    hits += score.hits;
  }
  hypothesis.quality =
      hits / (static_cast<double>(points.size()) * static_cast<double>(particles.size()));
  hypothesis.log_weight = std::log(std::max(hypothesis.quality, 1e-9));
  hypothesis.belief = moments(particles);
}

void merge_by_weight(const MergeConfig& config, std::vector<Hypothesis>& hypotheses) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    for (std::size_t j = i + 1; j < hypotheses.size();) {
      Hypothesis& first = hypotheses[i];
      const Hypothesis& second = hypotheses[j];
      if (!same_place(config, first.belief.mean, second.belief.mean)) {
        ++j;
        continue;
      }
      first.particles = heavier_half(first, second);
      first.belief = moments(first.particles);
      first.quality = std::max(first.quality, second.quality);
      first.log_weight = std::max(first.log_weight, second.log_weight);
      hypotheses.erase(hypotheses.begin() + static_cast<std::ptrdiff_t>(j));
    }
  }
}

void destroy_by_quality(const QualityRules& rules, std::vector<Hypothesis>& hypotheses) {
  const auto best = best_by_quality(hypotheses);
  if (!best) return;
  const int keep = hypotheses[*best].id;
  std::erase_if(hypotheses, [&](const Hypothesis& h) {
    return h.id != keep && h.quality < rules.destroy_below;
  });
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
