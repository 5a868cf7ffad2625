/// MH-AMCL: several populations of particles, each a hypothesis about the pose of the robot.
///
/// A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable Multi-Hypothesis
/// Monte Carlo Localization for Mobile Robots", 2022: predict, correct and reseed run at separate
/// rates; populations are created where a cascade matcher finds the scan, merged, destroyed, and
/// one is selected. We keep this structure. Differences: winners are refined below the grid's
/// resolution, places are weighted by rays as well as end points, and a posterior over all places
/// and the null hypothesis replaces fixed thresholds of quality. `PaperMhAmcl` follows the paper
/// exactly.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "castaway/localizer.hpp"
#include "localization/geometry/stage_timer.hpp"
#include "localization/hypotheses/blindness.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/mh_amcl/belief.hpp"
#include "localization/mh_amcl/mh_amcl_models.hpp"
#include "localization/search/searches.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: the same calls and seed give the same results.
class MhAmcl final : public Localizer {
 public:
  /// Starts at an unknown pose. @throws std::invalid_argument for an invalid map or settings.
  MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock = {});
  /// The same with models that other localizers may use, too; those of a 3-D map, too.
  MhAmcl(std::shared_ptr<const MhAmclModels> models, std::uint64_t seed, StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_imu(const Imu& imu) override { input_.take(imu); }
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  void predict(const std::optional<SE2>& step);
  void take_scan(const ScanTurn& scan);
  // Its stages.
  void correct(const ScanTurn& scan);
  void merge_alike(const ScanTurn& scan);
  void watch(const ScanTurn& scan);
  void select(const ScanTurn& scan);
  void create(const ScanTurn& scan);
  void destroy_unlikely(const ScanTurn& scan);
  void reseed(const ScanTurn& scan);

  /// Shared: the models of a large map take longer to build than a short run takes, and none of
  /// the localizers that use them outlives the others by design.
  std::shared_ptr<const MhAmclModels> models_;
  SensorInput input_;
  Belief belief_;
  Searches searches_;
  Blindness blindness_;
  StageTimer timer_;
  std::optional<Estimate> estimate_;
};

}  // namespace castaway::localization
