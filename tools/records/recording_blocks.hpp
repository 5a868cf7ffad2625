/// Pieces of a recording that are read one scan at a time: beams, particles, people.
#pragma once

#include <string>
#include <vector>

#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Every so many beams one is kept, so that at most `most` are.
std::size_t beam_stride(std::size_t beams, std::size_t most);

/// Index of the lidar, then every `stride`-th beam as the difference to the one before: 0 where
/// nothing came back, else the range in steps of `kRecordingPoint`, plus 1.
std::string pack_beams(std::size_t lidar, const LaserScan& scan, std::size_t stride);

/// How many populations; of each: id; 1 if it is the output; share and quality; mean x, y and yaw;
/// how many particles, and these by x, y relative to the mean: x as difference to the one before,
/// y as it is. Of all particles at most some `most` are kept, at least 8 a population.
std::string pack_populations(const std::vector<localization::PopulationView>& populations,
                             std::size_t most);

/// How many people; of each: id, x, y, yaw.
std::string pack_people(const std::vector<PersonTruth>& people);

}  // namespace castaway::testbed
