/// Builds localizers and the loop's configuration from a scenario.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "localization/mh_amcl/mh_amcl_models.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/foreign/lidar_facts.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/build/shared_models.hpp"
#include "tools/run/loop.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// What localizers are built for: one map, and what foreign ones are told besides.
struct LocalizerPlace {
  RosMap map;
  std::filesystem::path map_file = {};    ///< Its YAML file; empty: there is none.
  std::vector<LidarFacts> lidars = {};    ///< Those that are known before the run.
  std::filesystem::path log_folder = {};  ///< For `<name>.log` of programs; empty: no such files.
  RobotFacts robot = {};
  /// The 3-D map with voxels of an edge [m]; empty: there is none.
  std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume = {};
};

/// Builds the localizers of several runs on one map. What depends on the map alone is built once
/// and shared, by processes forked after the construction, too.
class LocalizerFactory {
 public:
  /// Throws std::invalid_argument if the map or a setting of `mh_amcl` is unusable,
  /// std::runtime_error if there is no 3-D map and a localizer works on one.
  LocalizerFactory(std::vector<LocalizerSpec> specs, LocalizerPlace place);

  /// The localizers of a run, as `build_localizers` builds them.
  [[nodiscard]] std::vector<NamedLocalizer> build(std::uint64_t seed) const;

 private:
  std::vector<LocalizerSpec> specs_;
  LocalizerPlace place_;
  localization::OccupancyGrid grid_;
  /// Of each specification; null if it is not `mh_amcl` in its default mode or on a 3-D map. Shared
  /// with the localizers, which may outlive the factory.
  std::vector<std::shared_ptr<const localization::MhAmclModels>> models_;
};

/// Where the models of a run's localizers may be already.
struct ModelsOfRun {
  SharedModels* models = nullptr;  ///< Of this process; nullptr: they are built.
  std::string settings{};          ///< Text of the localizers' settings, equal for equal ones only.
};

/// Root of the random numbers of the localizer `name` in a run with this seed.
std::uint64_t localizer_seed(std::uint64_t run_seed, const std::string& name);

/// Builds one localizer per specification on one map. Each has its own random substream of the seed
/// and, unless its models are shared, a clock for its stages. Throws std::invalid_argument if a map
/// or a setting is unusable, std::runtime_error if a program cannot be started or a library cannot
/// be loaded.
std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const LocalizerPlace& place, std::uint64_t seed,
                                             const ModelsOfRun& shared = {});

/// Builds the localizer that was greeted so; the seed is its own. Throws as `build_localizers`
/// does.
NamedLocalizer build_localizer(const LocalizerSpec& spec, const Greeting& greeting);

/// Configuration of the loop for a run of the scenario that starts at `start`.
LoopConfig loop_config(const Scenario& scenario, const SE2& start,
                       std::optional<double> start_height = std::nullopt);

}  // namespace castaway::testbed
