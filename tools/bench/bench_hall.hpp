/// A hall of boxes for benchmarks.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/world/world_spec.hpp"

namespace castaway::testbed {

/// Turned boxes of 0.2 to 1.5 m strewn over a square hall without walls about the origin, of `edge`
/// [m].
sim::WorldSpec bench_hall(int boxes, double edge, std::uint64_t seed);

/// People in mid-step, anywhere in it.
std::vector<sim::MovingBody> bench_people(int count, double edge, std::uint64_t seed);

}  // namespace castaway::testbed
