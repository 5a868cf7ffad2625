/// The random engine of the simulator.
#pragma once

#include <functional>
#include <random>
#include <string>

namespace castaway::sim {

/// The engine of every draw; streams are handed in by name (`SimulationStreams`), distributions
/// come from Boost.Random.
using Rng = std::mt19937_64;

/// The random stream of a name: "people/places", "people/walking/3"... Each person has its own, so
/// that one more person shifts the draws of no other.
using NamedStreams = std::function<Rng(const std::string& name)>;

}  // namespace castaway::sim
