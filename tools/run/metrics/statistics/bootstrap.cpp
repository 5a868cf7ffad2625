#include "tools/run/metrics/statistics/bootstrap.hpp"

#include <algorithm>
#include <numeric>

#include <boost/random/uniform_int_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint64_t kSeed = 1;  // Seed of every bootstrap; fixed, so that intervals do not
                                    // depend on the run.

using IndexDraw = boost::random::uniform_int_distribution<std::size_t>;

/// Fills `drawn` with random blocks of the sample, which wraps around at its end.
void draw(const std::vector<double>& sample, std::size_t block, localization::Rng& rng,
          std::vector<double>& drawn) {
  IndexDraw first(0, sample.size() - 1);
  for (std::size_t i = 0; i < drawn.size();) {
    std::size_t from = first(rng);
    for (std::size_t k = 0; k < block && i < drawn.size(); ++k) {
      drawn[i++] = sample[from];
      from = from + 1 == sample.size() ? 0 : from + 1;
    }
  }
}

double mean(const std::vector<double>& sample) {
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

/// Reorders the sample.
double median(std::vector<double>& sample) {
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  if (sample.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(sample.begin(), middle));
}

Interval central(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {percentile(values, 0.025), percentile(values, 0.975)};
}

}  // namespace

std::optional<BootstrapIntervals> bootstrap(const std::vector<double>& sample,
                                            const BootstrapConfig& config) {
  if (sample.size() < 2 * std::max<std::size_t>(config.block, 1)) return std::nullopt;
  localization::Rng rng = localization::substream(kSeed, "bootstrap/" + config.stream);
  std::vector<double> drawn(sample.size());
  std::vector<double> means;
  std::vector<double> medians;
  for (int i = 0; i < config.resamples; ++i) {
    draw(sample, std::max<std::size_t>(config.block, 1), rng, drawn);
    means.push_back(mean(drawn));
    medians.push_back(median(drawn));
  }
  return BootstrapIntervals{central(std::move(means)), central(std::move(medians))};
}

std::optional<Statistics> statistics_with_intervals(std::vector<double> sample,
                                                    const BootstrapConfig& config) {
  const auto intervals = bootstrap(sample, config);
  std::optional<Statistics> figures = statistics(std::move(sample));
  if (figures && intervals) {
    figures->mean_interval = intervals->mean;
    figures->median_interval = intervals->median;
  }
  return figures;
}

}  // namespace castaway::testbed
