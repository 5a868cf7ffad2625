#include "tools/twin/calibration_trials.hpp"

#include <array>
#include <cmath>
#include <filesystem>

#include <unistd.h>

#include <fmt/format.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "tools/files/file.hpp"
#include "tools/twin/twin_folder.hpp"
#include "tools/twin/twin_run.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTrialTrack = 0.4;  // [m] Of `kTrialRobot`.
constexpr const char* kTrialRobot = "butler";
constexpr std::array kTrialWorlds = {"office", "warehouse", "lab", "home"};

/// Settings of a simulated log.
struct TrialSettings {
  std::string world;
  double radius_error_left = 0.0;
  double radius_error_right = 0.0;
  double track_error = 0.0;
  double drift_along = 0.0;
  double drift_yaw_deg = 0.0;
  double sigma_m = 0.0;
  double sigma_relative = 0.0;
  double resolution_m = 0.0;
  double dropout = 0.0;
  double dropout_far = 0.0;
  double dropout_grazing = 0.0;
  double offset_s = 0.0;
  int people = 0;
};

double draw(double low, double high, localization::Rng& rng) {
  return boost::random::uniform_real_distribution<double>(low, high)(rng);
}

/// A value of either sign.
double draw_signed(double least, double most, localization::Rng& rng) {
  const double sign = draw(-1.0, 1.0, rng) < 0.0 ? -1.0 : 1.0;
  return sign * draw(least, most, rng);
}

TrialSettings draw_settings(const CalibrationTrialConfig& config, int index) {
  localization::Rng rng =
      localization::substream(config.seed, fmt::format("calibration/{}", index));
  TrialSettings s;
  s.world = kTrialWorlds[static_cast<std::size_t>(index) % kTrialWorlds.size()];
  s.radius_error_left = draw_signed(0.02, 0.06, rng);
  s.radius_error_right = draw_signed(0.02, 0.06, rng);
  s.track_error = draw_signed(0.03, 0.10, rng);
  s.drift_along = draw(0.01, 0.03, rng);
  s.drift_yaw_deg = draw(0.3, 1.5, rng);
  s.sigma_m = draw(0.003, 0.03, rng);
  s.sigma_relative = draw(0.0, 0.01, rng);
  s.resolution_m = index % 3 == 0 ? 0.01 : 0.0;
  s.dropout = draw(0.01, 0.1, rng);
  s.dropout_far = draw(0.05, 0.4, rng);
  s.dropout_grazing = draw(0.05, 0.5, rng);
  s.offset_s = draw(-0.08, 0.08, rng);
  s.people = static_cast<int>(draw(3.0, 13.0, rng));
  return s;
}

std::string scenario_of(const TrialSettings& s, double duration_s) {
  return fmt::format(
      "world: {}\nrobot: {}\nphysics: kinematic\nduration_s: {}\ndrive: {{route: explore}}\n"
      "lidar: {{profile: ideal, beams: 360, fov_deg: 359, angle_min_deg: -180, range_max: 12, "
      "range_min: 0.1, rate_hz: 10, noise: {{sigma_m: {}, sigma_relative: {}, resolution_m: {}, "
      "dropout: {}, dropout_far: {}, dropout_grazing: {}}}}}\n"
      "odometry: {{profile: ideal, radius_error_left: {}, radius_error_right: {}, track_error: {}, "
      "drift_along: {}, drift_yaw_deg: {}, ticks_per_turn: 4096}}\n"
      "people: {{count: {}}}\n"
      "events:\n  - fault: {{kind: lidar-clock, at_s: 0, for_s: 1e6, offset_s: {}}}\n",
      s.world, kTrialRobot, duration_s, s.sigma_m, s.sigma_relative, s.resolution_m, s.dropout,
      s.dropout_far, s.dropout_grazing, s.radius_error_left, s.radius_error_right, s.track_error,
      s.drift_along, s.drift_yaw_deg, s.people, s.offset_s);
}

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
Figure people_of(FittedLog fitted, const RosMap& map) {
  const ScratchFolder folder;
  write_twin_inputs(map, folder.path(), fitted);
  return fit_people(folder.path(), fitted);
}

}  // namespace

bool FoundSetting::is_near() const { return std::abs(found.value - truth) <= tolerance; }

bool FoundSetting::is_held() const {
  return found.interval.low <= truth && truth <= found.interval.high;
}

std::vector<FoundSetting> try_calibration(const CalibrationTrialConfig& config, int index) {
  const TrialSettings s = draw_settings(config, index);
  const std::uint64_t seed = config.seed * 1000 + static_cast<std::uint64_t>(index);
  const RecordedPlace place = run_scenario(scenario_of(s, config.duration_s), seed);
  const FittedLog fitted = fit_log(place, {.align = AlignBy::kAuto, .track = kTrialTrack});
  std::vector<FoundSetting> found;
  if (const auto& o = fitted.fit.odometry) {
    found.push_back(relative("radius_error_left", s.radius_error_left, o->radius_error_left, 0.1));
    found.push_back(
        relative("radius_error_right", s.radius_error_right, o->radius_error_right, 0.1));
    found.push_back(relative("track_error", s.track_error, o->track_error, 0.1));
    found.push_back(relative("drift_along", s.drift_along, o->drift_along, 0.2));
    found.push_back(relative("drift_yaw_deg", s.drift_yaw_deg, o->drift_yaw_deg, 0.2));
  }
  if (const auto& n = fitted.fit.noise) {
    const double sigma = s.sigma_m + s.sigma_relative * n->typical_range_m;
    found.push_back(relative("noise at typical range", sigma, n->sigma_typical, 0.1));
    found.push_back(relative("sigma_m", s.sigma_m, n->sigma_m, 0.1));
    found.push_back(relative("sigma_relative", s.sigma_relative, n->sigma_relative, 0.1));
  }
  if (const auto& l = fitted.fit.loss) {
    found.push_back(relative("dropout", s.dropout, l->dropout, 0.1));
    found.push_back(relative("dropout_far", s.dropout_far, l->dropout_far, 0.1));
    found.push_back(relative("dropout_grazing", s.dropout_grazing, l->dropout_grazing, 0.1));
  }
  if (const auto& c = fitted.fit.clock) {
    found.push_back({"clock offset", s.offset_s, c->offset_s, 0.005});
  }
  found.push_back(relative("people", s.people, people_of(fitted, place.map), 0.3));
  return found;
}

}  // namespace castaway::testbed
