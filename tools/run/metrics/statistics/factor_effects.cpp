#include "tools/run/metrics/statistics/factor_effects.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include <boost/random/uniform_int_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

/// Indices of the seeds that count, with repetitions.
using Picks = std::vector<std::size_t>;
/// The effects without intervals; empty if there is no variance.
using Estimator = std::function<std::vector<FactorEffect>(const Picks& picks)>;

double mean_of_all(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Mean square distance from the mean.
double spread_of(const std::vector<double>& values) {
  const double mean = mean_of_all(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return squares / static_cast<double>(values.size());
}

/// The same of a sample's population.
double variance_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  return spread_of(values) * n / (n - 1.0);
}

/// True for a variance that is no more than rounding makes of equal values.
bool is_nothing(double variance, double mean) { return variance <= 1e-24 * mean * mean; }

Interval central_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {percentile(values, 0.025), percentile(values, 0.975)};
}

/// Adds intervals to the effects of all seeds.
std::vector<FactorEffect> with_intervals(std::size_t seeds, const Estimator& estimate) {
  constexpr int kResamples = 500;
  constexpr std::uint64_t kSeed = 1;
  Picks picks(seeds);
  std::iota(picks.begin(), picks.end(), std::size_t{0});
  std::vector<FactorEffect> effects = estimate(picks);
  if (effects.empty()) return effects;
  std::vector<std::vector<double>> firsts(effects.size());
  std::vector<std::vector<double>> totals(effects.size());
  localization::Rng rng = localization::substream(kSeed, "bootstrap/effects");
  boost::random::uniform_int_distribution<std::size_t> any(0, seeds - 1);
  for (int i = 0; i < kResamples; ++i) {
    for (std::size_t& pick : picks) pick = any(rng);
    const std::vector<FactorEffect> drawn = estimate(picks);
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      firsts[k].push_back(drawn[k].first);
      totals[k].push_back(drawn[k].total);
    }
  }
  for (std::size_t k = 0; k < effects.size() && !firsts[k].empty(); ++k) {
    effects[k].first_interval = central_of(std::move(firsts[k]));
    effects[k].total_interval = central_of(std::move(totals[k]));
  }
  return effects;
}

std::vector<double> pick(const std::vector<double>& values, const Picks& picks) {
  std::vector<double> picked;
  for (const std::size_t i : picks) picked.push_back(values[i]);
  return picked;
}

/// A factor's place in the order of the combinations.
struct FactorPlace {
  std::size_t levels;
  std::size_t below;  ///< Combinations of the factors that vary faster.

  [[nodiscard]] std::size_t level(std::size_t combination) const {
    return combination / below % levels;
  }
};

/// Mean outcomes by level, then by seed.
std::vector<std::vector<double>> level_means(const std::vector<std::vector<double>>& values,
                                             const FactorPlace& factor) {
  std::vector<std::vector<double>> means(factor.levels, std::vector<double>(values[0].size(), 0.0));
  const double each = static_cast<double>(factor.levels) / static_cast<double>(values.size());
  for (std::size_t c = 0; c < values.size(); ++c) {
    std::vector<double>& sums = means[factor.level(c)];
    for (std::size_t s = 0; s < sums.size(); ++s) sums[s] += each * values[c][s];
  }
  return means;
}

/// Variance that a factor explains alone: that of the means of its levels, without what seeds that
/// are a sample let them differ by chance.
double main_variance(const std::vector<std::vector<double>>& means,
                     const std::vector<double>& of_seeds) {
  std::vector<double> of_levels;
  for (const auto& level : means) of_levels.push_back(mean_of_all(level));
  const double grand = mean_of_all(of_levels);
  double squares = 0.0;
  for (std::size_t l = 0; l < means.size(); ++l) {
    for (std::size_t s = 0; s < of_seeds.size(); ++s) {
      const double rest = means[l][s] - of_levels[l] - of_seeds[s] + grand;
      squares += rest * rest;
    }
  }
  const auto levels = static_cast<double>(means.size());
  const auto seeds = static_cast<double>(of_seeds.size());
  const double by_chance = squares / (seeds - 1.0) / (levels * seeds);
  return std::max(spread_of(of_levels) - by_chance, 0.0);
}

/// Mean variance of the outcomes that differ in a factor only.
double total_variance(const std::vector<std::vector<double>>& values, const FactorPlace& factor) {
  double sum = 0.0;
  double groups = 0.0;
  std::vector<double> group(factor.levels);
  for (std::size_t c = 0; c < values.size(); ++c) {
    if (factor.level(c) != 0) continue;
    for (std::size_t s = 0; s < values[c].size(); ++s) {
      for (std::size_t l = 0; l < factor.levels; ++l) group[l] = values[c + l * factor.below][s];
      sum += spread_of(group);
      groups += 1.0;
    }
  }
  return sum / groups;
}

std::vector<FactorEffect> estimate_factorial(const std::vector<int>& levels,
                                             const std::vector<std::vector<double>>& values) {
  const FactorPlace everything{values.size(), 1};
  std::vector<double> of_seeds(values[0].size(), 0.0);
  double within = 0.0;  // Mean variance between seeds.
  for (const auto& seeds : values) {
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      of_seeds[s] += seeds[s] / static_cast<double>(values.size());
    }
    within += variance_of(seeds) / static_cast<double>(values.size());
  }
  const double by_seed = variance_of(of_seeds);
  const double all = total_variance(values, everything) + by_seed;
  if (is_nothing(all, mean_of_all(of_seeds))) return {};
  std::vector<FactorEffect> effects;
  std::size_t below = values.size();
  for (const int count : levels) {
    below /= static_cast<std::size_t>(count);
    const FactorPlace factor{static_cast<std::size_t>(count), below};
    effects.push_back({main_variance(level_means(values, factor), of_seeds) / all,
                       total_variance(values, factor) / all});
  }
  effects.push_back({by_seed / all, within / all});
  return effects;
}

double mean_square_between(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return squares / static_cast<double>(a.size());
}

std::vector<FactorEffect> estimate_swapped(const SwappedOutcomes& outcomes, const Picks& picks) {
  const std::vector<double> first = pick(outcomes.first, picks);
  const std::vector<double> second = pick(outcomes.second, picks);
  std::vector<double> both = first;
  both.insert(both.end(), second.begin(), second.end());
  const double all = spread_of(both);
  if (is_nothing(all, mean_of_all(both))) return {};
  std::vector<FactorEffect> effects;
  for (const std::vector<double>& values : outcomes.swapped) {
    const std::vector<double> swapped = pick(values, picks);
    effects.push_back({1.0 - mean_square_between(second, swapped) / (2.0 * all),
                       mean_square_between(first, swapped) / (2.0 * all)});
  }
  return effects;
}

}  // namespace

std::vector<FactorEffect> factorial_effects(const FactorialOutcomes& outcomes) {
  constexpr std::size_t kFewestSeeds = 2;
  if (outcomes.values.empty() || outcomes.values[0].size() < kFewestSeeds) return {};
  return with_intervals(outcomes.values[0].size(), [&](const Picks& picks) {
    std::vector<std::vector<double>> picked;
    for (const auto& seeds : outcomes.values) picked.push_back(pick(seeds, picks));
    return estimate_factorial(outcomes.levels, picked);
  });
}

std::vector<FactorEffect> swapped_effects(const SwappedOutcomes& outcomes) {
  if (outcomes.first.size() < 2) return {};
  return with_intervals(outcomes.first.size(),
                        [&](const Picks& picks) { return estimate_swapped(outcomes, picks); });
}

}  // namespace castaway::testbed
