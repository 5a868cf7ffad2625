#include "tools/run/metrics/statistics/sign_flip.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint64_t kFlipSeed = 1;  // The same as of the bootstrap.
constexpr std::size_t kMostExact = 16;
constexpr int kFlips = 20000;

/// Tolerance for sums that differ only by rounding.
double threshold_of(const std::vector<double>& differences) {
  const double sum = std::accumulate(differences.begin(), differences.end(), 0.0);
  double size = 0.0;
  for (const double difference : differences) size += std::abs(difference);
  return std::abs(sum) - 1e-12 * size;
}

double exact(const std::vector<double>& differences) {
  const double threshold = threshold_of(differences);
  const std::uint64_t all = std::uint64_t{1} << differences.size();
  std::uint64_t as_far = 0;
  for (std::uint64_t flips = 0; flips < all; ++flips) {
    double sum = 0.0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
      sum += (flips >> i & 1U) != 0 ? -differences[i] : differences[i];
    }
    as_far += std::abs(sum) >= threshold ? 1 : 0;
  }
  return static_cast<double>(as_far) / static_cast<double>(all);
}

double sample_p_value(const std::vector<double>& differences, localization::Rng rng) {
  const double threshold = threshold_of(differences);
  int as_far = 1;
  for (int k = 0; k < kFlips; ++k) {
    double sum = 0.0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
      if (i % 32 == 0) bits = rng();
      sum += (bits >> (i % 32) & 1U) != 0 ? -differences[i] : differences[i];
    }
    as_far += std::abs(sum) >= threshold ? 1 : 0;
  }
  return static_cast<double>(as_far) / static_cast<double>(kFlips + 1);
}

}  // namespace

double sign_flip_p_value(const std::vector<double>& differences, const std::string& stream) {
  if (differences.empty()) return 1.0;
  if (differences.size() <= kMostExact) return exact(differences);
  return sample_p_value(differences, localization::substream(kFlipSeed, "sign-flips/" + stream));
}

double smallest_sign_flip_p_value(std::size_t pairs) {
  if (pairs == 0) return 1.0;
  const double exact = std::ldexp(2.0, -static_cast<int>(std::min<std::size_t>(pairs, 1000)));
  return pairs <= kMostExact ? exact : std::max(exact, 1.0 / (kFlips + 1));
}

std::size_t pairs_for_significance(std::size_t tests) {
  std::size_t pairs = 1;
  while (static_cast<double>(tests) * std::ldexp(2.0, -static_cast<int>(pairs)) >= kSignificance) {
    ++pairs;
  }
  return pairs;
}

std::vector<double> holm(const std::vector<double>& p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> corrected(p_values.size());
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const double scaled = static_cast<double>(order.size() - rank) * p_values[order[rank]];
    largest = std::min(1.0, std::max(largest, scaled));
    corrected[order[rank]] = largest;
  }
  return corrected;
}

}  // namespace castaway::testbed
