/// AMCL's sensor model on one map, selected by the settings.
#pragma once

#include <optional>
#include <vector>

#include "localization/amcl/amcl_config.hpp"

namespace castaway::localization {

/// Weighs poses by scans. Not copyable, since the beam model refers to the map.
class AmclSensor {
 public:
  /// @throws std::invalid_argument for an invalid map.
  AmclSensor(const AmclConfig& config, const OccupancyGrid& map);
  AmclSensor(const AmclSensor&) = delete;

  /// The map; shifted if `half_cell_shift` is set.
  [[nodiscard]] const OccupancyGrid& map() const { return map_; }
  /// True if a scan changes the weights of poses.
  [[nodiscard]] bool is_informative(const BeamScan& beams) const;
  /// [nats] Log-weight of each pose. `range_max` [m]: of the lidar.
  [[nodiscard]] std::vector<double> log_weights(const BeamScan& beams,
                                                const std::vector<SE2>& poses,
                                                double range_max) const;
  /// Mean likelihood of the returns at a pose, in [0, 1]; 0 without returns.
  [[nodiscard]] double quality(const BeamScan& beams, const SE2& T_map_base) const;

 private:
  AmclSensorModel model_;
  BeamSkipConfig beam_skip_;
  OccupancyGrid map_;
  LikelihoodField field_;
  std::optional<BeamModel> beam_model_;  ///< Used by kBeam only.
};

}  // namespace castaway::localization
