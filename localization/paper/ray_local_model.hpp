/// Observation model of the paper (eq. 5 to 7): a beam's error is the distance along the ray from
/// its end point to the nearest wall, searched only within 3 sigma.
///
/// A. Garcia et al., "Portable Multi-Hypothesis Monte Carlo Localization for Mobile Robots", 2022,
/// section III-B. Where the paper is silent: probes are one cell apart; a beam without a wall
/// within 3 sigma has the log-likelihood of 3 sigma and no hit; normalising constants are omitted,
/// since they are the same for all particles.
#pragma once

#include <algorithm>
#include <vector>

#include "localization/map/chebyshev_field.hpp"
#include "localization/sensor/pose_in_cells.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Parameters of the model.
struct RayLocalConfig {
  double sigma = 0.05;    ///< [m] Accuracy of the sensor.
  double hit_peak = 1.0;  ///< Height of a hit without error; hits are clamped to 1.
};

/// Score of a scan at a pose.
struct RayLocalScore {
  double log_likelihood = 0.0;  ///< Sum over beams; per beam 0 at best and -4.5 at worst.
  double hits = 0.0;            ///< Sum over beams of `exp(-error^2 / 2 sigma^2)`: h of eq. 9.
};

/// Evaluates scans against one map.
class RayLocalModel {
 public:
  /// @throws std::invalid_argument unless sigma is positive.
  RayLocalModel(const RayLocalConfig& config, const OccupancyGrid& grid);

  [[nodiscard]] RayLocalScore evaluate(const ScanPoints& points, const SE2& T_map_base) const;

  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  /// Distance of every cell to the nearest wall; capped, with a cap that no probe reaches if it is
  /// below 255.
  [[nodiscard]] const ChebyshevField& walls() const { return walls_; }
  /// Stands for the error of a beam without a wall; other errors are smaller. [cells]
  [[nodiscard]] std::size_t no_wall() const { return hit_.size() - 1; }
  /// Number of cells from the end point of a beam along its ray to the nearest wall.
  [[nodiscard]] std::size_t error_cells(const ScanPoints& points, std::size_t beam,
                                        const PoseInCells& pose) const;
  /// Hits of a beam whose error is this number of cells; never increases with it.
  [[nodiscard]] double hits_at(std::size_t cells) const { return hit_[std::min(cells, no_wall())]; }

 private:
  [[nodiscard]] bool is_occupied(float x_cells, float y_cells) const;

  GridFrame frame_;
  ChebyshevField walls_;
  // Indexed by the number of cells from the end point; the last entry: no wall.
  std::vector<double> log_likelihood_;
  std::vector<double> hit_;
};

}  // namespace castaway::localization
