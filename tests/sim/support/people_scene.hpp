/// Scenes with people for tests and benchmarks of ray casts.
#pragma once

#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/common/random.hpp"
#include "sim/world/world.hpp"

namespace castaway::sim {

/// Rotated boxes in a hall of 20 m x 20 m centred at the origin.
WorldSpec hall(int boxes);

/// Walking people at random places in the hall.
std::vector<MovingBody> strollers(int count, Rng& rng);

}  // namespace castaway::sim
