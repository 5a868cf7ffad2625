/// The 3-D map of a run's world for localizers.
#pragma once

#include <functional>
#include <memory>

#include "localization/space/volume/volume.hpp"
#include "sim/stages/simulation_config.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// How a robot stands: on its wheels and casters, with the centre of mass of all its parts.
localization::WheelStance stance_of(const sim::RobotModel& robot);

/// Surveys the world of a run when it is called, with voxels of this edge [m]. Where the robot
/// drives on the lowest floor only, there is ground wherever its body fits, under tables, too.
/// `known`: a map of the world, taken instead if its voxels are as large. Throws as `survey_world`
/// and `localization::Volume`.
std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::SimulationConfig& config, std::shared_ptr<const Map3d> known = nullptr);

}  // namespace castaway::testbed
