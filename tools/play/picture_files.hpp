/// The pictures, films and camera images of a simulated run.
#pragma once

#include <filesystem>

#include "tools/play/run_files.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/sources/build_simulation.hpp"

namespace castaway::testbed {

/// The report and the pictures that `outputs` asks for, and a film into `video` unless that is
/// empty, with the world that they show.
RunFiles picture_files(const OutputSpec& outputs, const std::filesystem::path& video,
                       const PreparedSimulation& prepared);

}  // namespace castaway::testbed
