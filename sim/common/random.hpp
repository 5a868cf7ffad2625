/// The random engine of the simulator and its commonest draws.
#pragma once

#include <functional>
#include <string>

#include <boost/random/mersenne_twister.hpp>

namespace castaway::sim {

/// The engine of every draw. Streams are passed by name (`SimulationStreams`); distributions are
/// Boost.Random's.
using Rng = boost::random::mt19937_64;

/// Returns the random stream of a name: "people/places", "people/walking/3", ... Each person has
/// its own, so that adding a person does not shift the draws of others.
using NamedStreams = std::function<Rng(const std::string& name)>;

/// Draws a uniform number from [low, high); `low` must be less than `high`.
double draw_between(double low, double high, Rng& rng);

/// Draws from the normal distribution with mean 0 and standard deviation 1.
double draw_normal(Rng& rng);

}  // namespace castaway::sim
