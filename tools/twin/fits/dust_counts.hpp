/// Beams at risk of grains by range, and the ranges at which grains returned them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace castaway::testbed {

inline constexpr double kDustStep = 0.1;  ///< [m] Of range.
inline constexpr std::size_t kDustSteps = 400;

/// Values of the steps of a beam.
using DustSteps = std::array<double, kDustSteps>;

/// The step that holds range `r` [m]; the first or last one outside.
std::size_t dust_step(double r);

/// Beams of a part of the log.
struct DustCounts {
  DustSteps metres{};        ///< [m] Of beams at risk of a grain, by range.
  std::vector<double> hits;  ///< [m] Ranges of grains.
  double beams = 0.0;
};

/// The counts of all blocks but one, with ascending hits.
DustCounts sum_dust(const std::vector<DustCounts>& blocks, std::size_t left_out);

/// Hits and metres up to a range, and beyond.
struct DustSplit {
  double near_hits = 0.0;
  double near_metres = 0.0;
  double far_hits = 0.0;
  double far_metres = 0.0;

  [[nodiscard]] double near_rate() const;  ///< [1/m]
  [[nodiscard]] double far_rate() const;   ///< [1/m]
  /// Grains per metre; things beyond their range are also among them. [1/m]
  [[nodiscard]] double grains() const;
  /// Of the hits, without terms that are the same for all splits. [nats]
  [[nodiscard]] double log_likelihood() const;
};

/// Splits counts with ascending hits at a range [m].
DustSplit split_dust(const DustCounts& counts, double range);

/// Beams at risk and hits within a metre of range.
struct DustBin {
  double range_m = 0.0;  ///< [m] In its middle.
  double metres = 0.0;   ///< [m]
  double hits = 0.0;
};

/// Those with at least a metre at risk.
std::vector<DustBin> bin_dust(const DustCounts& counts);

/// How far grains are seen, from counts with ascending hits: a little farther than the greatest
/// hit, unless those within some range are clearly more frequent, at least twice, than those
/// beyond. 10 m if there are fewer than five. [m]
double dust_range(const DustCounts& counts);

}  // namespace castaway::testbed
