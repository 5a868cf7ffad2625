/// MH-AMCL to the letter of the paper.
///
/// A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable Multi-Hypothesis
/// Monte Carlo Localization for Mobile Robots", 2022: predict, correct and reseed run at rates of
/// their own; populations are created where a cascade matcher finds the scan, merged, destroyed,
/// and the one of the best quality is selected. `PaperMhAmclConfig` says what was chosen where the
/// paper is silent.
#pragma once

#include "localization/hypotheses/unlisted.hpp"
#include "localization/localizer.hpp"
#include "localization/paper/paper_stages.hpp"
#include "localization/paper/patience.hpp"
#include "localization/stage_timer.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: same calls, same seed, same results.
class PaperMhAmcl final : public Localizer {
 public:
  /// Throws std::invalid_argument for a map or settings that make no sense. Starts at an unknown
  /// place.
  PaperMhAmcl(const PaperMhAmclConfig& config, const OccupancyGrid& map, std::uint64_t seed,
              StageClock clock = {});
  /// The same with other stages.
  PaperMhAmcl(const PaperMhAmclConfig& config, PaperStages stages, std::uint64_t seed,
              StageClock clock = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<Estimate> estimate() const override { return estimate_; }
  [[nodiscard]] Diagnostics diagnostics() const override;

 private:
  void predict(const std::optional<SE2>& step);
  void take_scan(const MatchScan& scan);
  void correct(const ScanPoints& points);
  void create(const MatchScan& scan);
  void select(Stamp now);

  PaperMhAmclConfig config_;
  PaperStages stages_;
  StageTimer timer_;
  SensorInput input_;
  Spawner spawner_;
  Populations populations_;
  Patience patience_;
  std::optional<Stamp> last_match_;
  std::optional<Estimate> estimate_;
};

}  // namespace castaway::localization
