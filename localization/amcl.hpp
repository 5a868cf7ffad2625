/// The baseline: adaptive Monte Carlo localization as in Nav2, implemented from its published
/// formulas.
///
/// Updates only after motion; three sensor models; KLD-sampling; random particles when the average
/// weight falls (off by default). The output is the mean of the heaviest cluster with the
/// covariance of the whole set. Intended differences: cell indices are rounded down (Nav2 shifts
/// the map by half a cell: `half_cell_shift`), and draws use our random streams.
#pragma once

#include "localization/amcl_config.hpp"
#include "localization/localizer.hpp"
#include "localization/stage_timer.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: the same calls and seed give the same results.
class Amcl final : public Localizer {
 public:
  /// @throws std::invalid_argument for a map without free cells, or invalid settings.
  Amcl(const AmclConfig& config, const OccupancyGrid& map, std::uint64_t seed,
       StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  [[nodiscard]] bool moved_enough(const SE2& T_odom_base) const;
  [[nodiscard]] bool is_awaited(const std::string& lidar, const SE2& T_odom_base);
  [[nodiscard]] bool is_informative(const BeamScan& beams) const;
  void update(const BeamScan& beams, double range_max, const SE2& T_odom_base);
  void weigh(const BeamScan& beams, double range_max);
  [[nodiscard]] std::vector<double> log_weights(const BeamScan& beams, double range_max) const;
  void resample();
  void publish(Stamp stamp, const SE2& T_odom_base);

  AmclConfig config_;
  OccupancyGrid map_;  ///< Shifted if `half_cell_shift` is set.
  LikelihoodField field_;
  std::optional<BeamModel> beam_model_;  ///< Used by kBeam only.
  FreeSpace free_space_;
  Rng rng_;
  StageTimer timer_;
  Intake intake_;
  ParticleSet particles_;
  RecoveryAverages averages_;
  std::optional<SE2> updated_at_;  ///< Odometry at the last update.
  SE2 T_map_odom_;
  Cluster output_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  double quality_ = 0.0;
  std::optional<Estimate> estimate_;
  std::map<std::string, bool> awaited_;  ///< By lidar: its next scan causes an update.
};

}  // namespace castaway::localization
