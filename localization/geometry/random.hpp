/// Random numbers: one engine, named substreams.
#pragma once

#include <cstdint>
#include <string_view>

#include <boost/random/mersenne_twister.hpp>

namespace castaway::localization {

/// The engine of every draw. Its output is that of `std::mt19937_64`, fixed by the C++ standard.
/// Engine and distributions come from Boost.Random, whose algorithms do not depend on the standard
/// library.
using Rng = boost::random::mt19937_64;

/// The substream `name` of the run with `seed`: a new consumer never shifts the draws of another.
Rng substream(std::uint64_t seed, std::string_view name);

}  // namespace castaway::localization
