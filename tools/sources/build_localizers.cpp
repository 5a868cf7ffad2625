#include "tools/sources/build_localizers.hpp"

#include <utility>
#include <variant>

#include "localization/amcl.hpp"
#include "localization/geometry/random.hpp"
#include "localization/mh_amcl.hpp"
#include "localization/paper/paper_mh_amcl.hpp"
#include "localization/paper/published/published_stages.hpp"
#include "tools/run/cpu_clock.hpp"

namespace castaway::testbed {
namespace {

/// Visitor that builds the localizer of each settings type.
struct Maker {
  std::unique_ptr<localization::Localizer> operator()(const localization::MhAmclConfig& c) const {
    return models ? std::make_unique<localization::MhAmcl>(models, seed)
                  : std::make_unique<localization::MhAmcl>(c, map, seed, thread_cpu_time);
  }
  std::unique_ptr<localization::Localizer> operator()(
      const localization::PaperMhAmclConfig& c) const {
    return std::make_unique<localization::PaperMhAmcl>(c, map, seed, thread_cpu_time);
  }
  std::unique_ptr<localization::Localizer> operator()(
      const localization::PublishedMhAmclConfig& c) const {
    return std::make_unique<localization::PaperMhAmcl>(
        c.paper, localization::published_stages(c, map), seed, thread_cpu_time);
  }
  std::unique_ptr<localization::Localizer> operator()(const localization::AmclConfig& c) const {
    return std::make_unique<localization::Amcl>(c, map, seed, thread_cpu_time);
  }

  const localization::OccupancyGrid& map;
  std::uint64_t seed;
  /// Null: built here, and the stages of the localizer are timed.
  std::shared_ptr<const localization::MhAmclModels> models;
};

NamedLocalizer build_localizer(const LocalizerSpec& spec, const localization::OccupancyGrid& map,
                               std::uint64_t seed,
                               std::shared_ptr<const localization::MhAmclModels> models) {
  localization::Rng stream = localization::substream(seed, "localizer/" + spec.name);
  return {spec.name, std::visit(Maker{map, stream(), std::move(models)}, spec.config),
          spec.relocalize_at_kidnap};
}

}  // namespace

std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const localization::OccupancyGrid& map,
                                             std::uint64_t seed) {
  std::vector<NamedLocalizer> localizers;
  for (const LocalizerSpec& spec : specs) {
    localizers.push_back(build_localizer(spec, map, seed, nullptr));
  }
  return localizers;
}

LocalizerFactory::LocalizerFactory(std::vector<LocalizerSpec> specs,
                                   localization::OccupancyGrid map)
    : specs_(std::move(specs)), map_(std::move(map)) {
  for (const LocalizerSpec& spec : specs_) {
    const auto* config = std::get_if<localization::MhAmclConfig>(&spec.config);
    models_.push_back(config ? std::make_shared<const localization::MhAmclModels>(*config, map_)
                             : nullptr);
  }
}

std::vector<NamedLocalizer> LocalizerFactory::build(std::uint64_t seed) const {
  std::vector<NamedLocalizer> localizers;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    localizers.push_back(build_localizer(specs_[i], map_, seed, models_[i]));
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
