/// The baseline: adaptive Monte Carlo localization as Nav2 runs it, written from its published
/// formulas.
///
/// Updates only after moving; likelihood field with weights `1 + sum pz^3`; KLD-sampling; random
/// particles after a fall of the average weight (off by default); the output is the mean of the
/// heaviest cluster. Differs on purpose: cells are taken by their floor (Nav2 shifts the map by
/// half a cell), draws come from our random streams.
#pragma once

#include "localization/filter/pose_bins.hpp"
#include "localization/filter/recovery_averages.hpp"
#include "localization/geometry/transform_buffer.hpp"
#include "localization/localizer.hpp"
#include "localization/motion/differential_motion.hpp"
#include "localization/sensor/likelihood_field_prob.hpp"
#include "localization/stage_timer.hpp"

namespace castaway::localization {

/// How the beams of a scan make a weight.
enum class AmclSensorModel {
  kLikelihoodField,      ///< `1 + sum pz^3`
  kLikelihoodFieldProb,  ///< `prod pz`, with beam skipping
};

/// Settings, with Nav2's defaults.
struct AmclConfig {
  DifferentialMotionConfig motion;
  AmclSensorModel model = AmclSensorModel::kLikelihoodField;
  LikelihoodFieldConfig sensor;
  BeamSkipConfig beam_skip;  ///< Used by kLikelihoodFieldProb only.
  KldConfig kld;
  RecoveryConfig recovery;
  double update_min_d = 0.25;  ///< [m] Along x or y of odom since the last update.
  double update_min_a = 0.2;   ///< [rad]
  int max_beams = 60;          ///< Beams used, by equal steps of their index.
  double max_range = 100.0;  ///< [m] Longer returns are ignored; also limits the lidar's own range.
  TransformBufferConfig buffer;
};

/// Throws std::invalid_argument naming the figure that is out of its range.
void validate(const AmclConfig& config);

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
  void update(const LaserScan& scan, const ScanPoints& points, const SE2& T_odom_base);
  void weigh(const ScanPoints& points, double range_max);
  [[nodiscard]] std::vector<double> log_weights(const ScanPoints& points, double range_max) const;
  void resample();
  void publish(Stamp stamp, const SE2& T_odom_base);

  AmclConfig config_;
  LikelihoodField field_;
  FreeSpace free_space_;
  Rng rng_;
  StageTimer timer_;
  TransformBuffer T_odom_base_;
  ParticleSet particles_;
  RecoveryAverages averages_;
  std::optional<SE2> updated_at_;  ///< Odometry at the last update.
  SE2 T_map_odom_;
  Cluster output_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();
  double quality_ = 0.0;
  std::optional<Estimate> estimate_;
  std::optional<Stamp> last_scan_;
  std::int64_t dropped_scans_ = 0;
};

}  // namespace castaway::localization
