#include "tools/twin/fits/mixed_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

using Bin = MixedFit::Bin;

constexpr std::size_t kMixedScans = 3000;
constexpr double kFlat = 0.05;      // [m] Between neighbouring beams on one surface.
constexpr double kBetween = 0.1;    // [m] A mixed range is this far from both surfaces.
constexpr double kLeastStep = 0.5;  // [m]
/// [m] Upper ends of the bins.
constexpr std::array kEnds{0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 1e9};

using Bins = std::array<Bin, kEnds.size()>;

/// A range; nothing if the beam did not return.
std::optional<double> range_of(const LaserScan& scan, std::size_t i) {
  const double r = scan.ranges[i];
  if (!(r > scan.range_min && r < 0.98 * scan.range_max)) return std::nullopt;
  return r;
}

bool are_flat(const LaserScan& scan, std::size_t i, std::size_t k) {
  const auto a = range_of(scan, i);
  const auto b = range_of(scan, k);
  return a && b && std::abs(*a - *b) < kFlat;
}

void add_step(double step, bool mixed, Bins& bins) {
  std::size_t k = 0;
  while (step > kEnds[k]) ++k;
  bins[k].step_m += step;
  bins[k].steps += 1.0;
  bins[k].mixed += mixed ? 1.0 : 0.0;
  bins[k].visible += 1.0 - 2.0 * kBetween / step;
}

/// Adds the counts of other bins.
void add_bins(const Bins& added, Bins& bins) {
  for (std::size_t k = 0; k < bins.size(); ++k) {
    bins[k].step_m += added[k].step_m;
    bins[k].steps += added[k].steps;
    bins[k].mixed += added[k].mixed;
    bins[k].visible += added[k].visible;
    bins[k].other += added[k].other;
  }
}

/// Adds the depth steps of a scan: from beam i to the next one, or to the next but one.
void add_steps(const LaserScan& scan, Bins& bins) {
  for (std::size_t i = 1; i + 3 < scan.ranges.size(); ++i) {
    if (!are_flat(scan, i - 1, i)) continue;
    const double a = *range_of(scan, i);
    if (are_flat(scan, i + 1, i + 2)) {
      const double step = std::abs(*range_of(scan, i + 1) - a);
      if (step > kLeastStep) add_step(step, false, bins);
    }
    const auto middle = range_of(scan, i + 1);
    if (!middle || !are_flat(scan, i + 2, i + 3)) continue;
    const double b = *range_of(scan, i + 2);
    const bool between = *middle > std::min(a, b) + kBetween && *middle < std::max(a, b) - kBetween;
    if (between && std::abs(b - a) > kLeastStep) add_step(std::abs(b - a), true, bins);
  }
}

/// The counts of a log by blocks of its scans.
std::vector<Bins> count_steps(const AlignedLog& log) {
  std::vector<Bins> blocks(Blocks::kCount);
  for (const std::size_t i : spread_scans(log, kMixedScans)) {
    add_steps(log.scans[i].scan, blocks[i * Blocks::kCount / log.scans.size()]);
  }
  return blocks;
}

/// Takes shares of the steps, by bin, for those that have something in between anyway.
void expect_others(const std::vector<double>& shares, Bins& bins) {
  for (std::size_t k = 0; k < shares.size(); ++k) {
    bins[k].other = shares[k] * bins[k].steps;
    bins[k].visible *= 1.0 - shares[k];
  }
}

Bins sum_without(const std::vector<Bins>& blocks, std::size_t left_out) {
  Bins sum;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    if (block != left_out) add_bins(blocks[block], sum);
  }
  return sum;
}

/// Shares of mixed steps below and above a reach, as a number of bins.
struct Shares {
  double below = 0.0;
  double above = 0.0;
};

double share_of(const Bins& bins, std::size_t from, std::size_t to) {
  double mixed = 0.0;
  double visible = 0.0;
  for (std::size_t k = from; k < to; ++k) {
    mixed += bins[k].mixed - bins[k].other;
    visible += bins[k].visible;
  }
  return visible > 0.0 ? std::clamp(mixed / visible, 0.0, 1.0) : 0.0;
}

Shares shares_of(const Bins& bins, std::size_t reach) {
  return {share_of(bins, 0, reach), share_of(bins, reach, bins.size())};
}

double log_likelihood(const Bins& bins, std::size_t reach) {
  const Shares shares = shares_of(bins, reach);
  double sum = 0.0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    if (bins[k].steps == 0.0) continue;
    const double share = k < reach ? shares.below : shares.above;
    const double expected = share * bins[k].visible + bins[k].other;
    const double p = std::clamp(expected / bins[k].steps, 1e-6, 1.0 - 1e-6);
    sum += bins[k].mixed * std::log(p) + (bins[k].steps - bins[k].mixed) * std::log1p(-p);
  }
  return sum;
}

/// The reach that explains the counts best; all bins unless a shorter one is clearly better and
/// larger steps are mixed at most half as often.
std::size_t best_reach(const Bins& bins) {
  constexpr double kClearly = 3.0;  // [nats]
  std::size_t best = bins.size();
  double most = log_likelihood(bins, best) + kClearly;
  for (std::size_t reach = 1; reach < bins.size(); ++reach) {
    const double value = log_likelihood(bins, reach);
    const Shares shares = shares_of(bins, reach);
    if (value <= most || shares.below < 2.0 * shares.above) continue;
    most = value;
    best = reach;
  }
  return best;
}

}  // namespace

std::vector<double> shares_in_between(const AlignedLog& log) {
  std::vector<double> shares;
  for (const Bin& bin : sum_without(count_steps(log), Blocks::kCount)) {
    shares.push_back(bin.steps > 0.0 ? bin.mixed / bin.steps : 0.0);
  }
  return shares;
}

std::optional<MixedFit> fit_mixed(const AlignedLog& log, const std::vector<double>& others) {
  constexpr double kFewest = 200.0;  // Steps.
  std::vector<Bins> blocks = count_steps(log);
  for (Bins& bins : blocks) expect_others(others, bins);
  const Bins all = sum_without(blocks, Blocks::kCount);
  MixedFit fit;
  for (Bin bin : all) {
    if (bin.steps == 0.0) continue;
    fit.steps += static_cast<std::size_t>(bin.steps);
    bin.step_m /= bin.steps;
    fit.bins.push_back(bin);
  }
  if (static_cast<double>(fit.steps) < kFewest) return std::nullopt;
  const LaserScan& scan = log.scans.front().scan;
  const std::size_t reach = best_reach(all);
  const double spacing_deg = std::abs(scan.angle_increment) * 180.0 / std::numbers::pi;
  const Figure opening = jackknife([&](std::size_t left_out) {
                           const Shares s = shares_of(sum_without(blocks, left_out), reach);
                           return std::vector{spacing_deg * std::max(s.below - s.above, 0.0)};
                         }).front();
  constexpr double kModel = 0.1;  // Relative; things between two surfaces count, too.
  fit.divergence_deg = widen(opening, kModel * opening.value);
  fit.other = shares_of(all, reach).above;
  fit.reach_m = reach == all.size() ? scan.range_max : kEnds[reach - 1];
  return fit;
}

}  // namespace castaway::testbed
