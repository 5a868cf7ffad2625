/// Builds localizers and the loop's configuration from a scenario.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "localization/mh_amcl_models.hpp"
#include "tools/run/loop.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// Builds the localizers of several runs on one map. What depends on the map alone is built once
/// and shared, by processes forked after the construction, too.
class LocalizerFactory {
 public:
  /// Throws std::invalid_argument if the map or a setting of `mh_amcl` is unusable.
  LocalizerFactory(std::vector<LocalizerSpec> specs, localization::OccupancyGrid map);

  /// The localizers of a run, as `build_localizers` builds them.
  [[nodiscard]] std::vector<NamedLocalizer> build(std::uint64_t seed) const;

 private:
  std::vector<LocalizerSpec> specs_;
  localization::OccupancyGrid map_;
  /// Of each specification; null if it is not `mh_amcl` in its default mode. Shared with the
  /// localizers, which may outlive the factory.
  std::vector<std::shared_ptr<const localization::MhAmclModels>> models_;
};

/// Builds one localizer per specification on one map. Each has its own random substream of the seed
/// and a clock for its stages. Throws std::invalid_argument if a map or a setting is unusable.
std::vector<NamedLocalizer> build_localizers(const std::vector<LocalizerSpec>& specs,
                                             const localization::OccupancyGrid& map,
                                             std::uint64_t seed);

/// Configuration of the loop for a run of the scenario that starts at `start`.
LoopConfig loop_config(const Scenario& scenario, const SE2& start);

}  // namespace castaway::testbed
