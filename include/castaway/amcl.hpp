/// AMCL, the baseline, for programs that carry it: adaptive Monte Carlo localization as in Nav2.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "castaway/grid.hpp"
#include "castaway/localizer.hpp"

namespace castaway {

/// The settings in which robots differ, and all others by name; names and defaults are Nav2's. An
/// option that is left at its default takes the value of the preset.
struct AmclOptions {
  std::uint64_t seed = 1;          ///< Root of its random numbers.
  std::string preset = "amcl";     ///< "amcl", "amcl-recovery", "amcl-global" or "amcl-prob".
  double laser_max_range = 100.0;  ///< [m] Longer returns are ignored.
  int max_beams = 60;              ///< Largest number of beams used per scan.
  int min_particles = 500;         ///< Of a cloud without spread.
  int max_particles = 2000;        ///< Of a wide cloud.
  double alpha1 = 0.2;             ///< Odometry: noise of rotation from rotation.
  double alpha2 = 0.2;             ///< Odometry: noise of rotation from translation.
  double alpha3 = 0.2;             ///< Odometry: noise of translation from translation.
  double alpha4 = 0.2;             ///< Odometry: noise of translation from rotation.
  double recovery_alpha_slow =
      0.0;  ///< Rate of the slow average of weights; 0: no random particles.
  double recovery_alpha_fast = 0.0;  ///< Rate of the fast average; 0: no random particles.
  double update_min_d = 0.25;        ///< [m] Least motion along x or y between two updates.
  double update_min_a = 0.2;         ///< [rad] Least rotation between two updates.
  /// Settings `localizers[].amcl.*` of docs/settings.md: keys and values, as YAML. They override
  /// the options above.
  std::map<std::string, std::string> settings{};

  /// Adds a setting by its key.
  AmclOptions& set(const std::string& key, const std::string& value) {
    settings[key] = value;
    return *this;
  }
};

/// The localizer. The same calls and seed give the same estimates. Can be moved, not copied.
class Amcl final : public Localizer {
 public:
  /// Starts anywhere on the map. @throws std::runtime_error for a setting that is unknown (naming
  /// the nearest known one) or out of range, std::invalid_argument for a map without free cells.
  explicit Amcl(const OccupancyGrid& map, const AmclOptions& options = {});

  void initialize(const std::optional<PoseWithCovariance>& start) override {
    localizer_->initialize(start);
  }
  void on_odometry(const Odometry& odometry) override { localizer_->on_odometry(odometry); }
  void on_scan(const LaserScan& scan) override { localizer_->on_scan(scan); }
  [[nodiscard]] std::optional<Estimate> estimate() const override { return localizer_->estimate(); }
  [[nodiscard]] Diagnostics diagnostics() const override { return localizer_->diagnostics(); }

 private:
  std::unique_ptr<Localizer> localizer_;
};

}  // namespace castaway
