#include "tools/twin/calibration_trials.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <unistd.h>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/twin/trial_settings.hpp"
#include "tools/twin/twin_folder.hpp"
#include "tools/twin/twin_run.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

FoundSetting relative(const char* name, double truth, const Figure& found, double share) {
  return {name, truth, found, share * std::abs(truth)};
}

/// A folder that is removed at the end.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("castaway-calibration-{}", ::getpid())) {
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The number of people, from twins in a folder of their own.
Figure people_of(const FittedLog& fitted, const RosMap& map) {
  const ScratchFolder folder;
  write_twin_inputs(map, fitted, folder.path());
  return fit_people(folder.path(), fitted);
}

/// Adds what a fit found of a setting that some trials lack.
void add_if_set(const FoundSetting& setting, std::vector<FoundSetting>& found) {
  if (setting.truth != 0.0) found.push_back(setting);
}

void add_odometry(const TrialSettings& s, const OdometryFit& fit,
                  std::vector<FoundSetting>& found) {
  constexpr double kNearMount = 0.015;   // [m]
  constexpr double kNearMountDeg = 0.3;  // [deg]
  found.push_back(relative("radius_error_left", s.radius_error_left, fit.radius_error_left, 0.1));
  found.push_back(
      relative("radius_error_right", s.radius_error_right, fit.radius_error_right, 0.1));
  found.push_back(relative("track_error", s.track_error, fit.track_error, 0.1));
  found.push_back(relative("drift_along", s.drift_along, fit.drift_along, 0.2));
  add_if_set(relative("drift_yaw_deg", s.drift_yaw_deg, fit.drift_yaw_deg, 0.2), found);
  add_if_set(relative("drift_turn_deg", s.drift_turn_deg, fit.drift_turn_deg, 0.2), found);
  add_if_set(relative("stamp_sigma_s", s.stamp_sigma_s, fit.stamp_sigma_s, 0.2), found);
  found.push_back({"mount x", s.mount.x, fit.drive_x_m, kNearMount});
  found.push_back({"mount y", s.mount.y, fit.drive_y_m, kNearMount});
  const double yaw_deg = s.mount.yaw * 180.0 / std::numbers::pi;
  found.push_back({"mount yaw", yaw_deg, fit.drive_yaw_deg, kNearMountDeg});
}

void add_lidar(const TrialSettings& s, const LogFit& fit, std::vector<FoundSetting>& found) {
  if (const auto& n = fit.noise) {
    const double sigma = s.sigma_m + s.sigma_relative * n->typical_range_m;
    found.push_back(relative("noise at typical range", sigma, n->sigma_typical, 0.1));
    found.push_back(relative("sigma_m", s.sigma_m, n->sigma_m, 0.1));
    found.push_back(relative("sigma_relative", s.sigma_relative, n->sigma_relative, 0.1));
  }
  if (const auto& l = fit.loss) {
    found.push_back(relative("dropout", s.dropout, l->dropout, 0.1));
    found.push_back(relative("dropout_far", s.dropout_far, l->dropout_far, 0.1));
    found.push_back(relative("dropout_grazing", s.dropout_grazing, l->dropout_grazing, 0.1));
  }
  if (fit.beam_bias) {
    add_if_set(relative("beam_bias_sigma_m", s.beam_bias_sigma_m, fit.beam_bias->sigma_m, 0.1),
               found);
  }
  if (fit.dust) add_if_set(relative("dust_per_m", s.dust_per_m, fit.dust->per_m, 0.1), found);
  if (const auto& c = fit.clock) {
    found.push_back({"clock offset", s.offset_s, c->offset_s, 0.005});
  }
}

}  // namespace

bool FoundSetting::is_near() const { return std::abs(found.value - truth) <= tolerance; }

bool FoundSetting::is_held() const {
  return found.interval.low <= truth && truth <= found.interval.high;
}

std::vector<FoundSetting> try_calibration(const CalibrationTrialConfig& config, int index) {
  const TrialSettings s = draw_settings(config.seed, index);
  const std::uint64_t seed = config.seed * 1000 + static_cast<std::uint64_t>(index);
  const RecordedPlace place = run_scenario(trial_scenario(s, config.duration_s), seed);
  const FittedLog fitted = fit_log(place, {.align = AlignBy::kAuto, .track = kTrialTrack});
  std::vector<FoundSetting> found;
  if (fitted.fit.odometry) add_odometry(s, *fitted.fit.odometry, found);
  add_lidar(s, fitted.fit, found);
  found.push_back(relative("people", s.people, people_of(fitted, place.map), 0.3));
  return found;
}

}  // namespace castaway::testbed
