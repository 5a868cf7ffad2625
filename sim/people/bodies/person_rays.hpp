/// What a lidar can hit of a person.
#pragma once

#include "sim/casting/moving_scene.hpp"
#include "sim/people/bodies/person.hpp"

namespace castaway::sim {

/// Two upright legs at the feet up to `kTorsoBottom`, above it a torso, an ellipse of 0.45 x 0.28
/// m, up to the shoulders, and a round head. Labelled kHitPerson + `index`.
MovingBody person_rays(const PersonBody& body, const PersonState& state, int index);
/// The same for a person whose heading is known as `ahead`, a unit vector in map.
MovingBody person_rays(const PersonBody& body, const PersonState& state,
                       const Eigen::Vector2d& ahead, int index);

}  // namespace castaway::sim
