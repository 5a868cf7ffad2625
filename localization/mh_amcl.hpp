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

#include "localization/hypotheses/map_search.hpp"
#include "localization/hypotheses/populations.hpp"
#include "localization/hypotheses/posterior.hpp"
#include "localization/localizer.hpp"
#include "localization/mh_amcl_config.hpp"
#include "localization/sensor/sensor_input.hpp"
#include "localization/stage_timer.hpp"
#include "localization/tracking_filter.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: the same calls and seed give the same results.
class MhAmcl final : public Localizer {
 public:
  /// Starts at an unknown pose. @throws std::invalid_argument for an invalid map or settings.
  MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  /// Map and models.
  struct Models {
    Models(const MhAmclConfig& config, OccupancyGrid grid);
    Models(const Models&) = delete;  // the models refer to the map

    OccupancyGrid map;
    DistanceField distances;
    EndpointModel endpoint;
    EvidenceModel evidence;
    CascadeMatcher matcher;
    CreateContext context;
  };
  void predict(const std::optional<SE2>& step);
  void take_scan(const ScanTurn& scan);
  void rescue(const ScanPoints& points);
  void merge();
  void create(const ScanTurn& scan);
  void list(const std::vector<WeighedPlace>& places, const ScanPoints& points);
  void learn();
  void select();
  [[nodiscard]] bool is_confident() const;

  MhAmclConfig config_;
  Models models_;
  TrackingFilter filter_;
  StageTimer timer_;
  SensorInput input_;
  Spawner spawner_;
  Populations populations_;
  Posterior posterior_;
  PlaceSearch search_;
  MatchSchedule schedule_;
  LostAndFound lost_and_found_;
  std::optional<Estimate> estimate_;
};

}  // namespace castaway::localization
