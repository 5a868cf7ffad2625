#include "tools/twin/fits/loss_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kLossScans = 1000;
constexpr int kSide = 12;            // Cells by range and by cosine.
constexpr double kBeforeWall = 0.3;  // [m] A return this much before the wall is something else's.
constexpr double kWithinMax = 0.95;  // Of the range limit; walls beyond may be out of range.

double log_likelihood(const LossShares& s, const std::vector<LossCell>& cells) {
  double sum = 0.0;
  for (const LossCell& cell : cells) {
    const double p = std::clamp(lost_share(s, cell), 1e-9, 1.0 - 1e-9);
    sum += cell.lost * std::log(p) + (cell.beams - cell.lost) * std::log1p(-p);
  }
  return sum;
}

/// The best value in [0, 1] of one share by golden sections; the likelihood has one maximum in it.
double best_share(const LossShares& at, double LossShares::*share,
                  const std::vector<LossCell>& cells) {
  constexpr double kGolden = 0.6180339887498949;
  const auto value = [&](double x) {
    LossShares s = at;
    s.*share = x;
    return log_likelihood(s, cells);
  };
  double low = 0.0;
  double high = 1.0;
  double a = high - kGolden * (high - low);
  double b = low + kGolden * (high - low);
  double value_a = value(a);
  double value_b = value(b);
  while (high - low > 1e-6) {
    if (value_a >= value_b) {
      high = b;
      b = a;
      value_b = value_a;
      a = high - kGolden * (high - low);
      value_a = value(a);
    } else {
      low = a;
      a = b;
      value_a = value_b;
      b = low + kGolden * (high - low);
      value_b = value(b);
    }
  }
  return value(0.0) >= value_a ? 0.0 : a;
}

/// Counts of one block of the log.
using Counts = std::array<LossCell, kSide * kSide>;

std::size_t cell_of(double range_per_max, double cosine) {
  const auto step = [](double x) { return std::clamp(static_cast<int>(x * kSide), 0, kSide - 1); };
  return static_cast<std::size_t>(step(range_per_max) * kSide + step(cosine));
}

/// What became of a beam that the map's wall should have returned.
enum class Fate { kWall, kBlocked, kLost, kInvalid };

Fate fate_of(const LaserScan& scan, std::size_t i, const ExpectedBeam& beam) {
  const float r = scan.ranges[i];
  if (std::isnan(r) || r < scan.range_min) return Fate::kInvalid;
  if (std::isinf(r) || r >= scan.range_max) return Fate::kLost;
  return r < beam.range - kBeforeWall ? Fate::kBlocked : Fate::kWall;
}

/// True if the next beams on both sides that returned anything returned the wall: people lose
/// beams, too, and those must not count as the wall's.
bool sees_wall(const LaserScan& scan, const std::vector<ExpectedBeam>& expected, std::size_t i) {
  constexpr std::ptrdiff_t kReach = 6;
  if (const Fate fate = fate_of(scan, i, expected[i]);
      fate == Fate::kBlocked || fate == Fate::kInvalid) {
    return false;
  }
  const auto count = static_cast<std::ptrdiff_t>(expected.size());
  for (const std::ptrdiff_t side : {-1, 1}) {
    for (std::ptrdiff_t step = 1; step <= kReach; ++step) {
      const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) + side * step;
      if (k < 0 || k >= count) break;
      const auto index = static_cast<std::size_t>(k);
      const Fate fate = fate_of(scan, index, expected[index]);
      if (fate == Fate::kBlocked) return false;
      if (fate == Fate::kWall) break;
    }
  }
  return true;
}

void count_scan(const AlignedLog& log, const AlignedScan& aligned, Counts& counts) {
  const LaserScan& scan = aligned.scan;
  const std::vector<ExpectedBeam> expected = expect_scan(log, aligned, scan.range_max);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const ExpectedBeam& beam = expected[i];
    if (!beam.straight || beam.range > kWithinMax * scan.range_max) continue;
    if (!sees_wall(scan, expected, i)) continue;
    const double range_per_max = beam.range / scan.range_max;
    LossCell& cell = counts[cell_of(range_per_max, beam.cosine)];
    cell.range_per_max += range_per_max;
    cell.cosine += beam.cosine;
    if (fate_of(scan, i, beam) == Fate::kLost) cell.lost += 1.0;
    cell.beams += 1.0;
  }
}

std::vector<LossCell> sum_blocks(const std::vector<Counts>& blocks, std::size_t left_out) {
  std::vector<LossCell> cells;
  for (std::size_t k = 0; k < kSide * kSide; ++k) {
    LossCell sum{0.0, 0.0};
    for (std::size_t block = 0; block < blocks.size(); ++block) {
      if (block == left_out) continue;
      const LossCell& cell = blocks[block][k];
      sum.range_per_max += cell.range_per_max;
      sum.cosine += cell.cosine;
      sum.beams += cell.beams;
      sum.lost += cell.lost;
    }
    if (sum.beams == 0.0) continue;
    sum.range_per_max /= sum.beams;
    sum.cosine /= sum.beams;
    cells.push_back(sum);
  }
  return cells;
}

double total_share(const std::vector<LossCell>& cells) {
  double beams = 0.0;
  double lost = 0.0;
  for (const LossCell& cell : cells) {
    beams += cell.beams;
    lost += cell.lost;
  }
  return beams > 0.0 ? lost / beams : 0.0;
}

}  // namespace

double lost_share(const LossShares& s, const LossCell& cell) {
  return 1.0 - (1.0 - s.dropout) * (1.0 - s.far * cell.range_per_max * cell.range_per_max) *
                   (1.0 - s.grazing * (1.0 - cell.cosine));
}

LossShares fit_loss(const std::vector<LossCell>& cells) {
  LossShares s;
  for (int round = 0; round < 100; ++round) {
    const LossShares before = s;
    s.dropout = best_share(s, &LossShares::dropout, cells);
    s.far = best_share(s, &LossShares::far, cells);
    s.grazing = best_share(s, &LossShares::grazing, cells);
    if (std::abs(s.dropout - before.dropout) + std::abs(s.far - before.far) +
            std::abs(s.grazing - before.grazing) <
        1e-5) {
      break;
    }
  }
  return s;
}

std::optional<LossFit> fit_loss(const AlignedLog& log) {
  constexpr std::size_t kFewestBeams = 500;
  Counts none;
  none.fill({0.0, 0.0});
  std::vector<Counts> blocks(Blocks::kCount, none);
  for (const std::size_t index : spread_scans(log, kLossScans)) {
    count_scan(log, log.scans[index], blocks[index * Blocks::kCount / log.scans.size()]);
  }
  LossFit fit;
  fit.cells = sum_blocks(blocks, Blocks::kCount);
  for (const LossCell& cell : fit.cells) {
    fit.beams += static_cast<std::size_t>(cell.beams);
  }
  if (fit.beams < kFewestBeams) return std::nullopt;
  const std::vector<Figure> figures = jackknife([&](std::size_t left_out) {
    const std::vector<LossCell> cells = sum_blocks(blocks, left_out);
    const LossShares shares = fit_loss(cells);
    return std::vector{shares.dropout, shares.far, shares.grazing, total_share(cells)};
  });
  constexpr double kModel = 0.03;  // Relative; the map shows the walls' directions roughly.
  fit.dropout = widen(figures[0], kModel * figures[3].value);
  fit.dropout_far = widen(figures[1], kModel * figures[3].value);
  fit.dropout_grazing = widen(figures[2], kModel * figures[2].value);
  fit.lost = widen(figures[3], kModel * figures[3].value);
  return fit;
}

}  // namespace castaway::testbed
