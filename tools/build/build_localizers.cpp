#include "tools/build/build_localizers.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

#include "localization/amcl/amcl.hpp"
#include "localization/geometry/random.hpp"
#include "localization/mh_amcl/mh_amcl.hpp"
#include "localization/paper/paper_mh_amcl.hpp"
#include "localization/paper/published/published_stages.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/build/foreign/library_localizer.hpp"
#include "tools/build/foreign/program_localizer.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/ros2/build_ros2.hpp"

namespace castaway::testbed {
namespace {

/// What a localizer is built from besides its settings.
struct Site {
  const LocalizerSpec& spec;
  const LocalizerPlace& place;
  const localization::OccupancyGrid& grid;
  std::uint64_t seed;
  /// Null: built here, and the stages of the localizer are timed.
  std::shared_ptr<const localization::MhAmclModels> models;
};

NamedLocalizer named(const Site& site, std::unique_ptr<localization::Localizer> localizer) {
  return {site.spec.name, std::move(localizer), site.spec.relocalize_at_kidnap};
}

Greeting greeting_of(const Site& site) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::absolute(site.place.map_file, ignored);
  return {site.spec.name,    site.seed,
          site.place.map,    site.place.map_file.empty() ? "" : file.string(),
          site.place.lidars, site.place.robot};
}

std::shared_ptr<const localization::MhAmclModels> models_on_map3d(
    const localization::MhAmcl3dConfig& config, const LocalizerPlace& place) {
  if (!place.volume) {
    throw std::runtime_error(
        "works on a 3-D map, and there is none: `castaway replay` takes one by --map3d, as do "
        "`castaway evaluate` and, for a log, `castaway live`; simulated worlds are surveyed");
  }
  return std::make_shared<const localization::MhAmclModels>(config.mh_amcl,
                                                            place.volume(config.voxel));
}

/// Visitor that builds the localizer of each settings type.
struct Maker {
  NamedLocalizer operator()(const localization::MhAmclConfig& c) const {
    if (site.models)
      return named(site, std::make_unique<localization::MhAmcl>(site.models, site.seed));
    return named(site,
                 std::make_unique<localization::MhAmcl>(c, site.grid, site.seed, thread_cpu_time));
  }
  NamedLocalizer operator()(const localization::MhAmcl3dConfig& c) const {
    if (site.models)
      return named(site, std::make_unique<localization::MhAmcl>(site.models, site.seed));
    return named(site, std::make_unique<localization::MhAmcl>(models_on_map3d(c, site.place),
                                                              site.seed, thread_cpu_time));
  }
  NamedLocalizer operator()(const localization::PaperMhAmclConfig& c) const {
    return named(site, std::make_unique<localization::PaperMhAmcl>(c, site.grid, site.seed,
                                                                   thread_cpu_time));
  }
  NamedLocalizer operator()(const localization::PublishedMhAmclConfig& c) const {
    return named(site, std::make_unique<localization::PaperMhAmcl>(
                           c.paper, localization::published_stages(c, site.grid), site.seed,
                           thread_cpu_time));
  }
  NamedLocalizer operator()(const localization::AmclConfig& c) const {
    return named(site,
                 std::make_unique<localization::Amcl>(c, site.grid, site.seed, thread_cpu_time));
  }
  NamedLocalizer operator()(const ProgramConfig& c) const {
    const std::filesystem::path& folder = site.place.log_folder;
    auto program = std::make_unique<ProgramLocalizer>(
        c, greeting_of(site),
        folder.empty() ? std::filesystem::path() : folder / (site.spec.name + ".log"));
    ProgramLocalizer* running = program.get();
    NamedLocalizer localizer = named(site, std::move(program));
    localizer.outside_cpu = [running] { return running->cpu(); };
    localizer.finish = [running] { return running->finish(); };
    return localizer;
  }
  NamedLocalizer operator()(const LibraryConfig& c) const {
    return named(site, std::make_unique<LibraryLocalizer>(c, greeting_of(site)));
  }
  NamedLocalizer operator()(const OwnConfig& c) const {
    if (!c.make)
      throw std::runtime_error(
          "is an object of the program that made the run: castaway.run takes it, in Python, or "
          "castaway::run, in C++");
    return named(site, c.make(greeting_of(site)));
  }
  NamedLocalizer operator()(const Ros2Config& c) const {
    NamedLocalizer node = build_ros2(c, greeting_of(site));
    node.relocalize_at_kidnap = site.spec.relocalize_at_kidnap;
    return node;
  }

  const Site& site;
};

/// Calls `build`, whose errors name the localizer.
template <typename Build>
auto naming(const LocalizerSpec& spec, const Build& build) {
  try {
    return build();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("localizer '" + spec.name + "': " + error.what());
  }
}

NamedLocalizer build_at(const Site& site) {
  return naming(site.spec, [&] { return std::visit(Maker{site}, site.spec.config); });
}

/// Null if the localizer is not `mh_amcl` in its default mode or on a 3-D map.
std::shared_ptr<const localization::MhAmclModels> models_of(
    const LocalizerSpec& spec, const LocalizerPlace& place,
    const localization::OccupancyGrid& grid) {
  if (const auto* config = std::get_if<localization::MhAmclConfig>(&spec.config)) {
    return std::make_shared<const localization::MhAmclModels>(*config, grid);
  }
  const auto* config = std::get_if<localization::MhAmcl3dConfig>(&spec.config);
  if (config == nullptr) return nullptr;
  return naming(spec, [&] { return models_on_map3d(*config, place); });
}

}  // namespace

std::uint64_t localizer_seed(std::uint64_t run_seed, const std::string& name) {
  return localization::substream(run_seed, "localizer/" + name)();
}

NamedLocalizer build_localizer(const LocalizerSpec& spec, const Greeting& greeting) {
  const LocalizerPlace place{greeting.map, greeting.map_file, greeting.lidars};
  const localization::OccupancyGrid grid = to_occupancy_grid(place.map);
  return build_at({spec, place, grid, greeting.seed, nullptr});
}

std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const LocalizerPlace& place, std::uint64_t seed,
                                             const ModelsOfRun& shared) {
  const localization::OccupancyGrid grid = to_occupancy_grid(place.map);
  std::vector<NamedLocalizer> localizers;
  for (const LocalizerSpec& spec : specs) {
    std::shared_ptr<const localization::MhAmclModels> models;
    const auto* config = std::get_if<localization::MhAmclConfig>(&spec.config);
    if (shared.models != nullptr && config != nullptr) {
      models = shared.models->get(spec.name + "\n" + shared.settings, *config, grid);
    }
    localizers.push_back(
        build_at({spec, place, grid, localizer_seed(seed, spec.name), std::move(models)}));
  }
  return localizers;
}

LocalizerFactory::LocalizerFactory(std::vector<LocalizerSpec> specs, LocalizerPlace place)
    : specs_(std::move(specs)), place_(std::move(place)), grid_(to_occupancy_grid(place_.map)) {
  for (const LocalizerSpec& spec : specs_) models_.push_back(models_of(spec, place_, grid_));
}

std::vector<NamedLocalizer> LocalizerFactory::build(std::uint64_t seed) const {
  std::vector<NamedLocalizer> localizers;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    const std::uint64_t own_seed = localizer_seed(seed, specs_[i].name);
    localizers.push_back(build_at({specs_[i], place_, grid_, own_seed, models_[i]}));
  }
  return localizers;
}

LoopConfig loop_config(const Scenario& scenario, const SE2& start,
                       std::optional<double> start_height) {
  LoopConfig config;
  if (!scenario.drive.by_truth()) config.drive_by = scenario.drive.by;
  config.watch = scenario.events.watched;
  config.orders = scenario.events.orders;
  if (!scenario.start.known) return config;
  const double s = scenario.start.sigma_m;
  const double r = scenario.start.sigma_yaw;
  const Eigen::Vector3d& wrong = scenario.start.wrong_by;
  config.start = {start * SE2{wrong.x(), wrong.y(), wrong.z()},
                  Eigen::Vector3d(s * s, s * s, r * r).asDiagonal(), start_height};
  return config;
}

}  // namespace castaway::testbed
