/// What hangs over a world and hides it from above.
#pragma once

#include <vector>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Parts roofs and ceilings from what stands below: they become items of their own, behind those
/// that they were part of, and cast no shadow, so that rooms are lit.
///
/// High is what lies wholly above 1.5 m. A roof is high and flat, and large: more than a quarter of
/// `extent` [m2] or 20 m2, by itself (the high flat faces of a mesh with walls) or together with
/// others (panels of a ceiling, which hang by themselves). Flat: less than 60 degrees steep.
std::vector<SceneItem> part_roofs(std::vector<SceneItem> items, float extent);

}  // namespace castaway::sim
