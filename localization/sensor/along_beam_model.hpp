/// Observation model on 3-D maps: likelihood of a scan's end points by how far along the beam,
/// ahead or back, the nearest surface is.
///
/// A. Garcia et al., "Portable Multi-Hypothesis Monte Carlo Localization for Mobile Robots", 2022,
/// section III-B (eq. 5 to 7), whose authors used planar maps. Differences: surfaces are met by
/// sphere tracing, not by probes a cell apart; the likelihood is that of `EndpointModel` by another
/// distance, with a floor and a number of independent beams.
#pragma once

#include "localization/sensor/endpoint_model.hpp"
#include "localization/space/volume/volume.hpp"

namespace castaway::localization {

/// Evaluates scans against one 3-D map; poses are in its atlas.
class AlongBeamModel {
 public:
  /// Surfaces are looked for within 3 `config.sigma`; without one there, the error is that.
  /// `volume` must outlive the model. @throws std::invalid_argument for invalid settings.
  AlongBeamModel(const EndpointConfig& config, const Volume& volume);

  /// As `EndpointModel::log_likelihood`: mean over beams times `independent_beams`; 0 is perfect.
  [[nodiscard]] double log_likelihood(const ScanPoints& points, const SE2& T_map_base) const;
  /// Log-likelihood of each beam; 0 at best.
  [[nodiscard]] std::vector<float> beam_log_likelihoods(const ScanPoints& points,
                                                        const SE2& T_map_base) const;
  /// Distance of each beam's end from the nearest surface along the beam, at most the reach. [m]
  [[nodiscard]] std::vector<float> errors(const ScanPoints& points, const SE2& T_map_base) const;
  /// [m]
  [[nodiscard]] float reach() const { return reach_; }

 private:
  /// Calls `take(error)` for each beam, in their order.
  template <typename Take>
  void take_errors(const ScanPoints& points, const SE2& T_map_base, const Take& take) const;
  /// Log-likelihood of an error.
  [[nodiscard]] float value(float error) const;

  EndpointConfig config_;
  const Volume* volume_;
  float reach_;
  SurfaceField::Table values_{};  ///< By the error, from 0 to the reach.
};

}  // namespace castaway::localization
