#include "tools/twin/fits/dust_counts.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

double hits_per_metre(double hits, double metres) { return metres > 0.0 ? hits / metres : 0.0; }

double hits_likelihood(double hits, double rate) {
  return hits > 0.0 ? hits * std::log(rate) : 0.0;
}

}  // namespace

std::size_t dust_step(double r) {
  return static_cast<std::size_t>(std::clamp(r / kDustStep, 0.0, kDustSteps - 1.0));
}

DustCounts sum_dust(const std::vector<DustCounts>& blocks, std::size_t left_out) {
  DustCounts sum;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    if (block == left_out) continue;
    for (std::size_t k = 0; k < kDustSteps; ++k) sum.metres[k] += blocks[block].metres[k];
    sum.hits.insert(sum.hits.end(), blocks[block].hits.begin(), blocks[block].hits.end());
    sum.beams += blocks[block].beams;
  }
  std::sort(sum.hits.begin(), sum.hits.end());
  return sum;
}

double DustSplit::near_rate() const { return hits_per_metre(near_hits, near_metres); }

double DustSplit::far_rate() const { return hits_per_metre(far_hits, far_metres); }

double DustSplit::grains() const { return std::max(near_rate() - far_rate(), 0.0); }

double DustSplit::log_likelihood() const {
  return hits_likelihood(near_hits, near_rate()) + hits_likelihood(far_hits, far_rate());
}

DustSplit split_dust(const DustCounts& counts, double range) {
  DustSplit split;
  for (std::size_t k = 0; k < kDustSteps; ++k) {
    const double near = std::clamp(range / kDustStep - static_cast<double>(k), 0.0, 1.0);
    split.near_metres += near * counts.metres[k];
    split.far_metres += (1.0 - near) * counts.metres[k];
  }
  const auto beyond = std::upper_bound(counts.hits.begin(), counts.hits.end(), range);
  split.near_hits = static_cast<double>(beyond - counts.hits.begin());
  split.far_hits = static_cast<double>(counts.hits.end() - beyond);
  return split;
}

std::vector<DustBin> bin_dust(const DustCounts& counts) {
  constexpr double kLeastMetres = 1.0;
  std::vector<DustBin> bins(static_cast<std::size_t>(kDustSteps * kDustStep));
  const auto bin_of = [&](double r) -> DustBin& {
    return bins[std::min(static_cast<std::size_t>(r), bins.size() - 1)];
  };
  for (std::size_t k = 0; k < kDustSteps; ++k) {
    bin_of(kDustStep * (static_cast<double>(k) + 0.5)).metres += counts.metres[k];
  }
  for (const double r : counts.hits) bin_of(r).hits += 1.0;
  for (std::size_t k = 0; k < bins.size(); ++k) bins[k].range_m = static_cast<double>(k) + 0.5;
  std::erase_if(bins, [](const DustBin& bin) { return bin.metres < kLeastMetres; });
  return bins;
}

double dust_range(const DustCounts& counts) {
  constexpr double kFewestHits = 5.0;
  constexpr double kUnseen = 10.0;  // [m]
  constexpr double kClearly = 3.0;  // [nats]
  if (static_cast<double>(counts.hits.size()) < kFewestHits) return kUnseen;
  const auto extend = [](double greatest, double hits) { return greatest * (hits + 1.0) / hits; };
  double best = extend(counts.hits.back(), static_cast<double>(counts.hits.size()));
  double most = split_dust(counts, best).log_likelihood() + kClearly;
  for (std::size_t k = 1; k < kDustSteps; ++k) {
    const DustSplit split = split_dust(counts, kDustStep * static_cast<double>(k));
    if (split.near_hits < kFewestHits || split.near_rate() < 2.0 * split.far_rate()) continue;
    if (split.log_likelihood() <= most) continue;
    most = split.log_likelihood();
    best = extend(counts.hits[static_cast<std::size_t>(split.near_hits) - 1], split.near_hits);
  }
  return best;
}

}  // namespace castaway::testbed
