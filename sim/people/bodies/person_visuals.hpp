/// Meshes of people, for rendering.
#pragma once

#include <vector>

#include "sim/people/bodies/person.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// A person in map: shoes, legs, coat, arms and head within the outline of the lidar's shape. The
/// number chooses the clothes.
std::vector<SceneItem> person_visuals(const PersonBody& body, const PersonState& state, int index);

}  // namespace castaway::sim
