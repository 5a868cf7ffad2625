/// What a plan says of pictures, films and the camera.
#pragma once

#include <filesystem>

#include "tools/play/execute.hpp"
#include "tools/scenario/sections/scenario.hpp"
#include "tools/sources/build_simulation.hpp"

namespace castaway::testbed {

/// Puts the pictures that `outputs` asks for, and a film into `video` unless that is empty, into
/// the plan, with the world that they show.
void plan_pictures(const OutputSpec& outputs, const std::filesystem::path& video,
                   const PreparedSimulation& prepared, RunPlan& plan);

}  // namespace castaway::testbed
