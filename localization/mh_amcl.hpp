/// MH-AMCL: several populations of particles, each a hypothesis about where the robot is.
///
/// A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable Multi-Hypothesis
/// Monte Carlo Localization for Mobile Robots", 2022: predict, correct and reseed run at rates of
/// their own; populations are created where a cascade matcher finds the scan, merged, destroyed,
/// and one is selected. This keeps that structure and differs in the parts: winners are refined
/// below the grid, places are weighed by rays as well as end points, and a posterior over all
/// places and "somewhere else" replaces the fixed gates of quality. `PaperMhAmcl` is the paper to
/// the letter.
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

/// The localizer. Deterministic: same calls, same seed, same results.
class MhAmcl final : public Localizer {
 public:
  /// Throws std::invalid_argument for a map or settings that make no sense. Starts at an unknown
  /// place.
  MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  /// What the map is asked.
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
