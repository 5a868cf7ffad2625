/// Meshes of people, for rendering.
#pragma once

#include <vector>

#include "sim/people/bodies/person.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

inline constexpr double kHipHeight = 0.85;  ///< [m] Upper ends of the legs,
inline constexpr double kHipSide = 0.09;    ///< [m] and how far they are from the middle.

/// A person in map: shoes, legs, coat, arms and head within the outline of the lidar's shape. The
/// number chooses the clothes. In this order: shoe, shin, knee and thigh of the left leg, and of
/// the right one; trunk, shoulders and both arms of the coat; face and hair. `roundness`: share of
/// the sides that round parts have in pictures.
std::vector<SceneItem> person_visuals(const PersonBody& body, const PersonState& state, int index,
                                      double roundness = 1.0);

}  // namespace castaway::sim
