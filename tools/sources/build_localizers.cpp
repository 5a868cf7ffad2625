#include "tools/sources/build_localizers.hpp"

#include "localization/amcl.hpp"
#include "localization/geometry/random.hpp"
#include "localization/mh_amcl.hpp"
#include "tools/run/cpu_clock.hpp"

namespace castaway::testbed {
namespace {

std::unique_ptr<localization::Localizer> build(const LocalizerSpec& spec,
                                               const localization::OccupancyGrid& map,
                                               std::uint64_t seed) {
  if (const auto* mh_amcl = std::get_if<localization::MhAmclConfig>(&spec.config)) {
    return std::make_unique<localization::MhAmcl>(*mh_amcl, map, seed, thread_cpu_time);
  }
  return std::make_unique<localization::Amcl>(std::get<localization::AmclConfig>(spec.config), map,
                                              seed, thread_cpu_time);
}

}  // namespace

std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const localization::OccupancyGrid& map,
                                             std::uint64_t seed) {
  std::vector<NamedLocalizer> localizers;
  for (const LocalizerSpec& spec : specs) {
    localization::Rng stream = localization::substream(seed, "localizer/" + spec.name);
    localizers.push_back({spec.name, build(spec, map, stream()), spec.relocalize_at_kidnap});
  }
  return localizers;
}

LoopConfig loop_config(const Scenario& scenario, const SE2& start) {
  LoopConfig config;
  if (scenario.drive.by != "truth") config.drive_by = scenario.drive.by;
  config.watch = scenario.events.watched;
  if (!scenario.start.known) return config;
  const double s = scenario.start.sigma_m;
  const double r = scenario.start.sigma_yaw;
  const Eigen::Vector3d& wrong = scenario.start.wrong_by;
  config.start = {start * SE2{wrong.x(), wrong.y(), wrong.z()},
                  Eigen::Vector3d(s * s, s * s, r * r).asDiagonal()};
  return config;
}

}  // namespace castaway::testbed
