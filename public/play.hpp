/// Runs and evaluations with localizers of the program around castaway, which may be in Python.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "castaway/run.hpp"
#include "tools/run/foreign_config.hpp"
#include "tools/run/run_sink.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway {

/// What makes a localizer of one's own in a run.
testbed::OwnConfig own_config(const OwnLocalizer& own);

/// Localizers of the program around castaway, by their names in the scenario.
using OwnConfigs = std::map<std::string, testbed::OwnConfig>;

/// A run, and who else rides on it.
struct PlayRequest {
  std::filesystem::path out;  ///< The run folder.
  bool force = false;         ///< It may hold other files, too.
  OwnConfigs own{};
  std::function<std::unique_ptr<testbed::RunSink>()> watcher{};  ///< As in `PlayOptions`.
};

/// `run` of a scenario that lists its localizers. Leaves the summary empty.
RunResult play(const Scenario& scenario, const PlayRequest& request);

}  // namespace castaway
