/// Blocks of a recording that are read one scan at a time: beams, particles, people.
#pragma once

#include <string>
#include <vector>

#include "castaway/localizer.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Smallest stride such that at most `most` of `beams` beams are kept.
std::size_t beam_stride(std::size_t beams, std::size_t most);

/// Packs the index of the lidar, then every `stride`-th beam as the difference to the previous one.
/// The value of a beam is 0 for no return, else 1 + the range in steps of `kRecordingPoint`.
std::string pack_beams(std::size_t lidar, const LaserScan& scan, std::size_t stride);

/// Packs the number of populations and for each: id; 1 if it is the output; share and quality; mean
/// x, y and yaw; number of particles, and the particles sorted by x and y relative to the mean: x
/// as the difference to the previous one, y as it is. About `most` particles in total are kept, but
/// at least 8 per population. `heights`: the mean's z follows its yaw.
std::string pack_populations(const std::vector<localization::PopulationView>& populations,
                             std::size_t most, bool heights = false);

/// Packs the number of people and for each: id, x, y, yaw.
std::string pack_people(const std::vector<PersonTruth>& people);

}  // namespace castaway::testbed
