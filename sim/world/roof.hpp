/// Separates roofs, which hide a world from above.
#pragma once

#include <vector>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Splits roofs and ceilings off the items below: they become items of their own, behind those that
/// they were part of, and cast no shadow, so that rooms are lit.
///
/// A roof lies completely above 1.5 m, is flat (less than 60 degrees steep) and large: it covers
/// more than a quarter of `extent` [m2] or 20 m2, either alone (the high flat faces of a mesh with
/// walls) or together with others (the separate panels of a ceiling).
std::vector<SceneItem> split_roofs(std::vector<SceneItem> items, float extent);

}  // namespace castaway::sim
