/// Observation model: likelihood of a scan's end points from a pose, by their distance to the
/// nearest wall.
///
/// S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics" (2005), section 6.4, as a product of
/// tempered beams: the sum of the logarithms is scaled to a number of independent beams, because
/// neighbouring beams see the same wall.
#pragma once

#include <variant>

#include "localization/map/interpolated_field.hpp"
#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/scan_points.hpp"
#include "localization/space/volume/volume.hpp"

namespace castaway::localization {

/// Parameters of the model of one beam.
struct EndpointConfig {
  /// [m] Spread of end points about walls: noise, map and pose errors together.
  double sigma = 0.12;
  /// Likelihood of an end point far from any wall, relative to one on a wall.
  double floor = 0.08;
  double independent_beams = 12;  ///< The scan counts as this many independent beams.
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const EndpointConfig& config);

/// Log-likelihood of one end point at `distance` [m] from a wall; 0 on a wall.
double endpoint_log_likelihood(const EndpointConfig& config, double distance);

/// Evaluates scans against one map, planar or 3-D; poses are in map or in the atlas.
class EndpointModel {
 public:
  EndpointModel(const EndpointConfig& config, const DistanceField& distances);
  /// `volume` must outlive the model. Where it has no ground, all beams are far from any surface.
  EndpointModel(const EndpointConfig& config, const Volume& volume);

  [[nodiscard]] const EndpointConfig& config() const { return config_; }
  [[nodiscard]] const GridFrame& frame() const;
  /// Log-likelihood of a scan from a pose: mean over beams times `independent_beams`; 0 is perfect.
  /// Also 0 without beams.
  [[nodiscard]] double log_likelihood(const ScanPoints& points, const SE2& T_map_base) const;
  /// Log-likelihood of each beam; 0 at best.
  [[nodiscard]] std::vector<float> beam_log_likelihoods(const ScanPoints& points,
                                                        const SE2& T_map_base) const;

 private:
  struct PlanarField {
    InterpolatedField values;
    MapToGrid to_grid;
  };
  struct VolumeField {
    const Volume* volume;
    SurfaceField::Table values;
  };
  template <typename Take>
  void look_up(const ScanPoints& points, const SE2& T_map_base, const Take& take) const;

  EndpointConfig config_;
  std::variant<PlanarField, VolumeField> field_;
};

}  // namespace castaway::localization
