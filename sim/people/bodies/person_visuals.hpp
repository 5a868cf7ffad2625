/// What people look like.
#pragma once

#include <vector>

#include "sim/people/bodies/person.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// A person in map: shoes, legs, coat, arms and head, the outline that its lidar shape has; dressed
/// by its number.
std::vector<SceneItem> person_visuals(const PersonBody& body, const PersonState& state, int index);

}  // namespace castaway::sim
