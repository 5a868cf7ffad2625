/// Correction and reseed of one population (paper, sections III-B and III-C), with winners refined
/// below the spacing of the particles.
#pragma once

#include <optional>

#include "localization/filter/reseed.hpp"
#include "localization/hypotheses/hypothesis.hpp"
#include "localization/matching/refine.hpp"

namespace castaway::localization {

/// Tracks populations. Conditioned once, applied to all of them.
class TrackingFilter {
 public:
  TrackingFilter(const EndpointModel& model, const ReseedConfig& reseed, const RefineConfig& refine)
      : model_(model), reseed_(reseed), refine_(refine) {}

  /// Weighs the particles by a scan. If the effective sample size becomes too small, reseeds around
  /// the refined winner.
  void correct(Hypothesis& hypothesis, const ScanPoints& points) const;
  /// Resamples the particles by weight; their number follows from their spread.
  void reseed(Hypothesis& hypothesis) const;
  /// Belief about base near `T_map_base` from the scan alone.
  [[nodiscard]] PoseMoments belief_at(const SE2& T_map_base, const ScanPoints& points) const;

 private:
  void reseed(Hypothesis& hypothesis, const std::optional<PoseGaussian>& winner) const;
  [[nodiscard]] PoseGaussian refine_winner(const SE2& T_map_best, const PoseMoments& predicted,
                                           const ScanPoints& points) const;

  EndpointModel model_;
  ReseedConfig reseed_;
  RefineConfig refine_;
};

}  // namespace castaway::localization
