/// Beam model of a range finder with AMCL's weights.
///
/// S. Thrun, W. Burgard, D. Fox, "Probabilistic Robotics" (2005), section 6.3. The likelihood of a
/// range z for an expected range e is the sum of four parts:
///   hit:   z_hit exp(-(z - e)^2 / 2 sigma_hit^2)
///   short: z_short lambda_short exp(-lambda_short z)   if z < e
///   max:   z_max                                       without a return
///   rand:  z_rand / range_max                          with a return
/// The factors that normalise hit and short are omitted, and beams are combined by AMCL's ad-hoc
/// sum: the weight is `1 + sum pz^3`.
#pragma once

#include "localization/map/occupancy_grid.hpp"
#include "localization/sensor/beam_scan.hpp"

namespace castaway::localization {

/// Parameters, with Nav2's names and defaults.
struct BeamModelConfig {
  double z_hit = 0.5;
  double z_short = 0.05;
  double z_max = 0.05;
  double z_rand = 0.5;
  double sigma_hit = 0.2;     ///< [m]
  double lambda_short = 0.1;  ///< [1/m]
};

/// @throws std::invalid_argument if a value is out of range.
void validate(const BeamModelConfig& config);

/// Evaluates scans against one map, which must outlive the model. Expected ranges are cast to the
/// border of the first cell that is not free; 60 beams of 2000 particles take tens of milliseconds.
class BeamModel {
 public:
  BeamModel(const BeamModelConfig& config, const OccupancyGrid& grid);

  /// Weight of a pose, at least 1. `range_max` [m]: of the lidar.
  [[nodiscard]] double weight(const BeamScan& scan, const SE2& T_map_base, double range_max) const;

  /// Likelihood pz of a return at `range` if the map has a wall at `expected`. [m]
  [[nodiscard]] double return_probability(double range, double expected, double range_max) const;
  /// Likelihood pz of no return if the map has a wall at `expected`. [m]
  [[nodiscard]] double miss_probability(double expected, double range_max) const;

 private:
  [[nodiscard]] double hit(double error) const;
  [[nodiscard]] std::vector<double> expected_ranges(const ScanPoints& points, const SE2& T_map_base,
                                                    double range_max) const;

  BeamModelConfig config_;
  const OccupancyGrid& grid_;
};

}  // namespace castaway::localization
