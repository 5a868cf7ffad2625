/// Correction and reseed of one population (paper, sections III-B and III-C), with winners refined
/// below the spacing of the particles.
///
/// Correction of a population that is a mixture of normal distributions: each component climbs to
/// the maximum of the scan and odometry likelihoods together, and takes the curvature there.
///
/// An iterated extended Kalman filter, for which the scan is one measurement: B. M. Bell, F. W.
/// Cathey, "The Iterated Kalman Filter Update as a Gauss-Newton Method", IEEE Transactions on
/// Automatic Control 38 (1993). A component's weight changes by Laplace's approximation of its
/// evidence.
#pragma once

#include <optional>

#include "localization/filter/gaussian_mixture.hpp"
#include "localization/filter/reseed.hpp"
#include "localization/hypotheses/hypothesis.hpp"
#include "localization/matching/pose_climber.hpp"
#include "localization/sensor/along_beam_model.hpp"

namespace castaway::localization {

/// Corrects a mixture by a scan. `refine` is that of hill climbing.
void correct(GaussianMixture& mixture, const MixtureConfig& config, const PoseClimber& climber,
             const RefineConfig& refine, const ScanPoints& points);

/// Tracks populations. Conditioned once, applied to all of them.
class TrackingFilter {
 public:
  /// Winners climb by registration with `ndt`, if it is given. Particles are weighed by
  /// `along_beams`, if it is given, in place of `model`.
  TrackingFilter(const EndpointModel& model, const ReseedConfig& reseed, const RefineConfig& refine,
                 const MixtureConfig& mixture = {}, const std::optional<NdtRegistration>& ndt = {},
                 const std::optional<AlongBeamModel>& along_beams = {})
      : model_(model),
        reseed_(reseed),
        refine_(refine),
        mixture_(mixture),
        ndt_(ndt),
        along_beams_(along_beams) {}

  /// Corrects a population by a scan. Particles: weighs them; if the effective sample size becomes
  /// too small, reseeds around the refined winner.
  void correct(Hypothesis& hypothesis, const ScanPoints& points) const;
  /// Resamples particles by weight; their number follows from their spread.
  void reseed(Hypothesis& hypothesis) const;
  /// Belief about base near `T_map_base` from the scan alone.
  [[nodiscard]] PoseMoments belief_at(const SE2& T_map_base, const ScanPoints& points) const;

 private:
  [[nodiscard]] PoseClimber climber() const { return {model_, ndt_ ? &*ndt_ : nullptr}; }
  void correct_particles(Hypothesis& hypothesis, const ScanPoints& points) const;
  void reseed(Hypothesis& hypothesis, const std::optional<PoseGaussian>& winner) const;
  [[nodiscard]] PoseGaussian refine_winner(const SE2& T_map_best, const PoseMoments& predicted,
                                           const ScanPoints& points) const;

  EndpointModel model_;
  ReseedConfig reseed_;
  RefineConfig refine_;
  MixtureConfig mixture_;
  std::optional<NdtRegistration> ndt_;
  std::optional<AlongBeamModel> along_beams_;
};

}  // namespace castaway::localization
