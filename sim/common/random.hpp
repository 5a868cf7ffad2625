/// The random engine of the simulator.
#pragma once

#include <functional>
#include <random>
#include <string>

namespace castaway::sim {

/// The engine of every draw. Streams are passed by name (`SimulationStreams`); distributions are
/// Boost.Random's.
using Rng = std::mt19937_64;

/// Returns the random stream of a name: "people/places", "people/walking/3", ... Each person has
/// its own, so that adding a person does not shift the draws of others.
using NamedStreams = std::function<Rng(const std::string& name)>;

}  // namespace castaway::sim
