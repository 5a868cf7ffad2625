#include "tools/twin/odometry/miss_bins.hpp"

#include <algorithm>
#include <cmath>

#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

/// One stretch of a bin.
struct BinnedMiss {
  double at = 0.0;
  double size = 0.0;      ///< Of the miss.
  double variance = 0.0;  ///< By the model.
};

MissBin bin_of(const std::vector<BinnedMiss>& misses, std::size_t from, std::size_t to) {
  constexpr double kOfNormal = 1.4826;  // Standard deviation over the median of the sizes.
  MissBin bin;
  std::vector<double> sizes;
  for (std::size_t i = from; i < to; ++i) {
    sizes.push_back(misses[i].size / std::sqrt(misses[i].variance));
    bin.at += misses[i].at;
    bin.model += misses[i].variance;
  }
  const auto count = static_cast<double>(to - from);
  std::sort(sizes.begin(), sizes.end());
  bin.at /= count;
  bin.model = std::sqrt(bin.model / count);
  bin.measured = bin.model * kOfNormal * percentile(sizes, 0.5);
  return bin;
}

std::vector<MissBin> bin_misses(std::vector<BinnedMiss> misses) {
  constexpr std::size_t kBins = 8;
  constexpr std::size_t kFewest = 10;
  std::stable_sort(misses.begin(), misses.end(),
                   [](const BinnedMiss& a, const BinnedMiss& b) { return a.at < b.at; });
  const std::size_t each = std::max(misses.size() / kBins, kFewest);
  std::vector<MissBin> bins;
  for (std::size_t from = 0; from + each <= misses.size(); from += each) {
    bins.push_back(bin_of(misses, from, from + each));
  }
  return bins;
}

}  // namespace

std::vector<MissBin> yaw_by_turn(const std::vector<Stretch>& stretches, const DriveErrors& errors,
                                 const OdometryNoise& noise) {
  std::vector<BinnedMiss> misses;
  for (const Stretch& s : stretches) {
    misses.push_back({s.turn, std::abs(miss_of(s, errors).yaw), noise.variances(s)(2)});
  }
  return bin_misses(std::move(misses));
}

std::vector<MissBin> along_by_speed(const std::vector<Stretch>& stretches,
                                    const DriveErrors& errors, const OdometryNoise& noise) {
  std::vector<BinnedMiss> misses;
  for (const Stretch& s : stretches) {
    const double speed = std::sqrt(0.5 * s.speeds.sum());
    misses.push_back({speed, std::abs(miss_of(s, errors).x), noise.variances(s)(0)});
  }
  return bin_misses(std::move(misses));
}

}  // namespace castaway::testbed
