/// A hall of boxes for benchmarks.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/casting/moving_scene.hpp"
#include "sim/world/world.hpp"

namespace castaway::testbed {

/// Boxes of 0.2 to 1.5 m at random poses in a square hall without walls, centred at the origin,
/// with edge `edge` [m].
sim::WorldSpec bench_hall(int boxes, double edge, std::uint64_t seed);

/// Walking people at random places in the hall.
std::vector<sim::MovingBody> bench_people(int count, double edge, std::uint64_t seed);

}  // namespace castaway::testbed
