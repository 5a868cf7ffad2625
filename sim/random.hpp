/// The random engine of the simulator.
#pragma once

#include <random>

namespace castaway::sim {

/// The engine of every draw; streams are handed in by name (`SimulationStreams`), distributions
/// come from Boost.Random.
using Rng = std::mt19937_64;

}  // namespace castaway::sim
