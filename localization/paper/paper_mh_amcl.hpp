/// MH-AMCL exactly as in the paper.
///
/// A. Garcia, F. Martin, J. M. Guerrero, F. J. Rodriguez, V. Matellan, "Portable Multi-Hypothesis
/// Monte Carlo Localization for Mobile Robots", 2022: predict, correct and reseed run at separate
/// rates; populations are created where a cascade matcher finds the scan, merged, destroyed, and
/// the one with the best quality is selected. `PaperMhAmclConfig` has our choices where the paper
/// is silent.
#pragma once

#include <cstdint>
#include <optional>

#include "castaway/localizer.hpp"
#include "localization/geometry/stage_timer.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/paper/paper_belief.hpp"
#include "localization/paper/paper_stages.hpp"

namespace castaway::localization {

/// The localizer. Deterministic: the same calls and seed give the same results.
class PaperMhAmcl final : public Localizer {
 public:
  /// Starts at an unknown pose. @throws std::invalid_argument for an invalid map or settings.
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
  void create(const MatchScan& scan);

  PaperMhAmclConfig config_;
  PaperStages stages_;
  SensorInput input_;
  PaperBelief belief_;
  StageTimer timer_;
  std::optional<Stamp> last_match_;
  std::optional<Estimate> estimate_;
};

}  // namespace castaway::localization
