/// Scenes with people for tests and benchmarks of the casts.
#pragma once

#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/common/random.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// Uniform in [low, high).
double uniform(double low, double high, Rng& rng);

/// Turned boxes in a hall of 20 m x 20 m about the origin.
WorldSpec hall(int boxes);

/// People in mid-step, anywhere in the hall.
std::vector<MovingBody> strollers(int count, Rng& rng);

}  // namespace castaway::sim
