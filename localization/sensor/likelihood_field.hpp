/// Likelihood-field sensor model with AMCL's weights.
///
/// S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics" (2005), table 6.3, with AMCL's ad-hoc sum
/// over beams: the weight is `1 + sum pz^3` with `pz = z_hit exp(-d^2 / 2 sigma_hit^2) + z_rand /
/// range_max`.
#pragma once

#include "localization/map/interpolated_field.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Parameters, with Nav2's names and defaults.
struct LikelihoodFieldConfig {
  double z_hit = 0.5;
  double z_rand = 0.5;
  double sigma_hit = 0.2;     ///< [m]
  double max_distance = 2.0;  ///< [m] Distances to walls are capped at this.
};

/// Evaluates scans against one map; distances are those of the cell that contains the end point.
class LikelihoodField {
 public:
  LikelihoodField(const LikelihoodFieldConfig& config, const OccupancyGrid& grid);

  /// Weight of a pose, at least 1. `range_max` [m]: of the lidar.
  [[nodiscard]] double weight(const ScanPoints& points, const SE2& T_map_base,
                              double range_max) const;
  /// Mean of `exp(-d^2 / 2 sigma_hit^2)` over the beams, in [0, 1]; 0 without beams.
  [[nodiscard]] double quality(const ScanPoints& points, const SE2& T_map_base) const;

  /// Distance from every end point to the nearest wall. [m]
  [[nodiscard]] std::vector<double> distances(const ScanPoints& points,
                                              const SE2& T_map_base) const;
  /// Likelihood pz of a beam that ends `distance` [m] from a wall.
  [[nodiscard]] double beam_probability(double distance, double range_max) const;

 private:
  LikelihoodFieldConfig config_;
  DistanceField distances_;
  std::vector<float> gaussian_;  ///< exp(-d^2 / 2 sigma^2) per cell.
  float outside_;
  [[nodiscard]] float gaussian_at(float x_cells, float y_cells) const;
};

}  // namespace castaway::localization
