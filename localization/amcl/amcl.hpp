/// The baseline: adaptive Monte Carlo localization as in Nav2, implemented from its published
/// formulas.
///
/// Updates only after motion; three sensor models; KLD-sampling; random particles when the average
/// weight falls (off by default). The output is the mean of the heaviest cluster with the
/// covariance of the whole set. Intended differences: cell indices are rounded down (Nav2 shifts
/// the map by half a cell: `half_cell_shift`), and draws use our random streams.
#pragma once

#include <cstdint>
#include <optional>

#include "castaway/localizer.hpp"
#include "localization/amcl/amcl_filter.hpp"
#include "localization/amcl/amcl_sensor.hpp"
#include "localization/amcl/update_trigger.hpp"
#include "localization/filter/pose_bins.hpp"
#include "localization/geometry/stage_timer.hpp"
#include "localization/input/intake.hpp"
#include "localization/sensor/beam_scan.hpp"

namespace castaway::localization {

/// State of the filter after an update.
struct AmclResult {
  Cluster output;                                        ///< The heaviest cluster.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< Of the whole population.
  double quality = 0.0;                                  ///< At the output, in [0, 1].
  SE2 T_map_odom;                                        ///< From the output and odometry.
};

/// The localizer. Deterministic: the same calls and seed give the same results.
class Amcl final : public Localizer {
 public:
  /// Starts at an unknown pose. @throws std::invalid_argument for a map without free cells, or
  /// invalid settings.
  Amcl(const AmclConfig& config, const OccupancyGrid& map, std::uint64_t seed,
       StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  void update(const BeamScan& beams, double range_max, const SE2& T_odom_base);

  AmclConfig config_;
  AmclSensor sensor_;
  AmclFilter filter_;
  StageTimer timer_;
  Intake intake_;
  UpdateTrigger trigger_;
  AmclResult result_;
  std::optional<Estimate> estimate_;
};

}  // namespace castaway::localization
