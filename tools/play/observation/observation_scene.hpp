/// The picture of an observation: robot, beams, and the map as the localizer sees it.
#pragma once

#include "sim/scene/scene.hpp"
#include "tools/play/observation/observation.hpp"

namespace castaway::testbed {

/// Settings of a picture.
struct ObservationView {
  double reach = 3.0;   ///< [m] How far the map is shown left and right of the robot.
  float aspect = 1.6F;  ///< Width / height of the image.
};

/// The robot on its map with the axes of base and lidar (x red, y green, z blue), the beams from
/// the lidar to their end points, and these green where the map explains them, red where it does
/// not. Seen from the side on which a slope is steepest in profile.
sim::Scene observation_scene(const Observation& observation, const ObservationView& view);

}  // namespace castaway::testbed
