/// The pictures, films and camera images of a simulated run.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/play/run_files.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {

/// The report and the pictures that `outputs` asks for, and a film into `video` unless that is
/// empty, with the world that they show. `report` writes the page.
RunFiles picture_files(const OutputSpec& outputs, const std::filesystem::path& video,
                       const ReportWriter& report, const PreparedSimulation& prepared);

/// What moves in pictures of a run: people, and what its events change. `source` must outlive it;
/// nothing if nothing moves.
std::function<std::vector<sim::SceneItem>()> moving_items(const SimulatorSource& source,
                                                          bool people,
                                                          std::set<std::string> changing);

/// Names of the objects that changes put, take away or turn.
std::set<std::string> changing_objects(const std::vector<sim::WorldChange>& changes);

}  // namespace castaway::testbed
