/// MH-AMCL, castaway's localizer, for programs that carry it: multi-hypothesis Monte Carlo
/// localization, which finds a robot again that was carried elsewhere.
///
///     castaway::MhAmclOptions options;
///     options.max_range = 12.0;
///     options.set("posterior.kidnap", "-6");
///     castaway::MhAmcl localizer(map, options);
///     localizer.on_odometry(...);
///     localizer.on_scan(...);
///     if (const auto estimate = localizer.estimate(); estimate && !estimate->lost) ...
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "castaway/grid.hpp"
#include "castaway/localizer.hpp"

namespace castaway {

/// The settings in which robots differ, and all others by name. An option that is left at its
/// default takes the value of the mode.
struct MhAmclOptions {
  std::uint64_t seed = 1;           ///< Root of its random numbers.
  std::string mode = "improved";    ///< "improved", "paper" or "published" (docs/localization.md).
  double max_range = 40.0;          ///< [m] Longer returns are ignored.
  int max_beams = 90;               ///< Largest number of beams used per scan.
  int max_particles = 200;          ///< Of a population with a wide spread.
  double correct_rate_hz = 10.0;    ///< [Hz] Rate of the correction.
  double trans_per_m = 0.1;         ///< [m/sqrt(m)] Odometry: sigma of the position after 1 m.
  double trans_per_rad = 0.02;      ///< [m/sqrt(rad)] Odometry: the same after turning by 1 rad.
  double rot_per_m = 0.06;          ///< [rad/sqrt(m)] Odometry: sigma of the yaw after 1 m.
  double rot_per_rad = 0.1;         ///< [rad/sqrt(rad)] Odometry: the same after turning by 1 rad.
  double found = 0.998;             ///< Least probability at which a lost output counts as found.
  double stays = 0.95;              ///< Least probability at which a found output stays found.
  double false_alarms_per_h = 6.0;  ///< Tolerated; more of them find kidnaps sooner.
  double budget_ms = 1.0;           ///< [ms] Mean nominal CPU time of the searches of a scan.
  double budget_most_ms = 50.0;     ///< [ms] Largest nominal CPU time of the searches of a scan.
  /// Settings `localizers[].mh_amcl.*` of docs/settings.md: keys and values, as YAML. They override
  /// the options above.
  std::map<std::string, std::string> settings{};

  /// Adds a setting by its key.
  MhAmclOptions& set(const std::string& key, const std::string& value) {
    settings[key] = value;
    return *this;
  }
};

/// The localizer. The same calls and seed give the same estimates. Can be moved, not copied.
class MhAmcl final : public Localizer {
 public:
  /// Starts anywhere on the map. @throws std::runtime_error for a setting that is unknown (naming
  /// the nearest known one) or out of range, std::invalid_argument for an unusable map.
  explicit MhAmcl(const OccupancyGrid& map, const MhAmclOptions& options = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override {
    localizer_->initialize(start);
  }
  void on_odometry(const Odometry& odometry) override { localizer_->on_odometry(odometry); }
  void on_imu(const Imu& imu) override { localizer_->on_imu(imu); }
  void on_scan(const LaserScan& scan) override { localizer_->on_scan(scan); }
  [[nodiscard]] std::optional<Estimate> estimate() const override { return localizer_->estimate(); }
  [[nodiscard]] Diagnostics diagnostics() const override { return localizer_->diagnostics(); }

 private:
  std::unique_ptr<Localizer> localizer_;
};

}  // namespace castaway
