/// The baseline: adaptive Monte Carlo localization as Nav2 runs it, written from its published
/// formulas.
///
/// Updates only after moving; three sensor models; KLD-sampling; random particles after a fall of
/// the average weight (off by default); the output is the mean of the heaviest cluster, its
/// covariance that of the whole set. Differs on purpose: cells are taken by their floor (Nav2
/// shifts the map by half a cell: `half_cell_shift`), draws come from our random streams.
#pragma once

#include "localization/amcl_config.hpp"
#include "localization/localizer.hpp"
#include "localization/stage_timer.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: same calls, same seed, same results.
class Amcl final : public Localizer {
 public:
  /// Throws std::invalid_argument for a map without free cells or settings that make no sense.
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
  [[nodiscard]] bool says_something(const BeamScan& beams) const;
  void update(const BeamScan& beams, double range_max, const SE2& T_odom_base);
  void weigh(const BeamScan& beams, double range_max);
  [[nodiscard]] std::vector<double> log_weights(const BeamScan& beams, double range_max) const;
  void resample();
  void publish(Stamp stamp, const SE2& T_odom_base);

  AmclConfig config_;
  OccupancyGrid map_;  ///< As Nav2 would place it.
  LikelihoodField field_;
  std::optional<BeamModel> beam_model_;  ///< Of kBeam only.
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
  std::map<std::string, bool> awaited_;  ///< By lidar: its next scan makes an update.
};

}  // namespace castaway::localization
